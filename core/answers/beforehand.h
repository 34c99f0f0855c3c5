#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/base/finding.h"
#include "core/base/problem.h"
#include "core/base/result.h"
#include "core/session/measurement.h"

namespace alidade {

/// Returns the first error that prevented the fit of an arc, or that there are no readings. Empty if every
/// arc with readings was fitted. `fitted` is the number of fitted arcs of the measurement.
std::optional<Problem> absence(const Measurement& measurement, std::size_t fitted,
                               const std::vector<FitFinding>& findings);

/// Returns the findings on positions, set-up and model of a session whose positions are all fitted. Fails
/// with the reason if a position could not be fitted. `fit` is that of the measurement.
Result<std::vector<Finding>> findingsBeforehand(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
