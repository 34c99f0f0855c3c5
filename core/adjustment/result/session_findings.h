#pragma once

#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// A finding for each of the two positions that the intersection needs and the measurement lacks.
std::vector<FitFinding> missingPositions(const Measurement& measurement);

/// Problems of the session's model: an unknown effect, the published vertical angle.
std::vector<FitFinding> modelFindings(const Measurement& measurement);

/// Findings on the session as a whole: a missing position, radii of one rigid guideway that differ, a result
/// away from the reference, a problem of the model.
std::vector<FitFinding> sessionFindings(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
