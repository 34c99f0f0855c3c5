#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/answers/fit_answer.h"
#include "core/session/measurement.h"

namespace alidade {

// The JSON document of `alidade-cli fit --json`, ending in a newline. Lengths in mm, y up, residuals in
// arcseconds. `intersection` is absent without arcs at 0° and 180°, `decision` without a tolerance or an
// intersection, `intersection_as_found` without a diagnosis. What has no finite value is null: reduced χ²
// without redundancy, and every uncertainty of the published method, which states none.

std::string fitJson(const FitAnswer& answer);
std::string fitJson(const std::string& name, const Measurement& measurement, const PublishedSessionFit& fit);

}  // namespace alidade
