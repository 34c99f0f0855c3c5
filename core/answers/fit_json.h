#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/answers/fit_answer.h"
#include "core/session/measurement.h"

namespace alidade {

// Returns the JSON document of `alidade-cli fit --json`, ending in a newline. Lengths are in mm, y up,
// residuals in arcseconds. `intersection` is absent without arcs at 0° and 180°, `decision` without a
// tolerance or an intersection, `intersection_measured` without a diagnosis. Values that are not finite are
// null: reduced χ² without redundancy, and every uncertainty of the published method.
// `digest`: SHA-256 of the session's file; empty: unknown.

std::string fitJson(const FitAnswer& answer);
std::string fitJson(const std::string& name, const Measurement& measurement, const PublishedSessionFit& fit,
                    const std::string& digest = {});

}  // namespace alidade
