#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// The size of each effect, and of a jump between a zero and the first visit, that would explain the distance
/// of Δd from the reference: of all such sizes, the most plausible and least visible one. Excluded are sizes
/// that the readings contradict, by `clearlyDifferent` σ relative to the best size, effects of known size,
/// and all-or-nothing effects. The most plausible first; empty without a reference with its σ. `inquiry` must
/// not use the reference.
std::vector<Required> whatItWouldTake(const Inquiry& inquiry);

}  // namespace alidade
