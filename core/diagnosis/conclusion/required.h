#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

/// What it would take of each effect, and of a jump between a zero and the first place, to explain how far Δd
/// is from the reference: of all sizes that would, the one that is the most plausible and shows the least.
/// Left out is what the readings exclude at that size, by `clearlyDifferent` σ against the size they are best
/// explained by, and what is all or nothing. The most plausible first; empty without a reference with its σ.
/// `inquiry`: one that does not heed the reference.
std::vector<Required> whatItWouldTake(const Inquiry& inquiry);

}  // namespace alidade
