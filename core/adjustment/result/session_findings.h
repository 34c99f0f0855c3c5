#pragma once

#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// A finding for each of the two positions that the intersection needs and the measurement does not hold.
std::vector<FitFinding> missingPositions(const Measurement& measurement);

/// What about the session's model needs care: an effect that is none, the published vertical angle.
std::vector<FitFinding> modelFindings(const Measurement& measurement);

/// What the session as a whole says about itself, beyond its single arcs: a missing position, radii of one
/// rigid guideway that differ, a result away from the reference, a model that needs care.
std::vector<FitFinding> sessionFindings(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
