#pragma once

#include <vector>

#include "core/diagnosis/explanation.h"

namespace alidade {

/// For the .cpp files of this room only. Sets of components, grown one component at a time with the noise
/// held at `variance` times the stated one; the best few of each size are kept. Their `logOdds` and
/// `logEvidence` are against nothing at the same noise. The first is the empty set.
std::vector<Explanation> grownSets(const Leftover& leftover, const std::vector<Component>& candidates,
                                   const SearchOptions& options, double variance);

}  // namespace alidade
