#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns a table of the contributions to every uncertainty. `quantity` is `intersection_as_measured` (with
/// every plausible effect), `intersection_of_fit` (readings, zeros and distance only), or `x`, `y` and
/// `radius` of each arc. `share` is the share of the variance of that quantity. `found` is null without a
/// diagnosis. The first quantity is then absent; the second is absent without an intersection.
std::string budgetCsv(const SessionFit& fit, const Diagnosis* found);

}  // namespace alidade
