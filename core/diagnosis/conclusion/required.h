#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// Returns the size at which each effect, or a jump between a zero and the first visit, explains the
/// difference of Δd from the reference. The sizes of an effect's parameters are together the most plausible
/// and least visible. Sizes that fit the readings worse than the best size by more than `clearlyDifferent` σ,
/// effects of known size and all-or-nothing effects are excluded. The most plausible effect is the first.
/// Empty without a reference with its σ. `inquiry` must not use the reference.
std::vector<Required> whatItWouldTake(const Inquiry& inquiry);

}  // namespace alidade
