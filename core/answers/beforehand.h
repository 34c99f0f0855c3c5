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

/// Why not every arc of the measurement was fitted, `fitted` of them were: the first error found. Empty where
/// every one was.
std::optional<Problem> absence(const Measurement& measurement, std::size_t fitted,
                               const std::vector<FitFinding>& findings);

/// For what rests on all positions of a session: fails where one of them could not be fitted, with the
/// reason; else what has to be known about positions, set-up and model. `fit` is that of the measurement.
Result<std::vector<Finding>> findingsBeforehand(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
