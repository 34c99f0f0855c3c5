#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// For each effect, and for a jump between a zero and the first visit: the size that would explain the
/// distance of Δd from the reference; of several, the most plausible and least visible. Excluded are sizes
/// that the readings contradict, by `clearlyDifferent` σ relative to the best size, effects of known size,
/// and all-or-nothing effects. The most plausible first; empty without a reference with its σ. `inquiry` must
/// not use the reference.
std::vector<Required> whatItWouldTake(const Inquiry& inquiry);

}  // namespace alidade
