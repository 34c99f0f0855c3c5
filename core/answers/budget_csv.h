#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// A table of where every uncertainty comes from. `quantity` tells of what: `intersection_as_measured` with
/// everything plausible, `intersection_of_fit` of the readings, zeros and distance alone, and `x`, `y` and
/// `radius` of each arc. `share`: of the variance of that quantity. `found`: null without a diagnosis; the
/// first quantity is not in the table then, the second not without an intersection.
std::string budgetCsv(const SessionFit& fit, const Diagnosis* found);

}  // namespace alidade
