#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/gap/gap_model.h"

namespace alidade {

// The causes that have a name.

/// The effects of the catalogue but those in `leftOut`.
std::vector<Component> effectComponents(const Leftover& leftover, const std::vector<std::string>& leftOut,
                                        const PriorOdds& odds);
/// The effects of the catalogue but those in `leftOut`, what bends with its second derivatives. `leftover` is
/// that of the model.
std::vector<Component> effectsBeyond(const GapModel& model, const Leftover& leftover,
                                     const std::vector<std::string>& leftOut, const PriorOdds& odds);

/// A step before any row; of long sessions before every n-th. One that a single row alone in its visit
/// would show leaves what a misreading of that row leaves, which is the commoner: it is for comparison only.
std::vector<Component> jumpComponents(const Leftover& leftover, const PriorOdds& odds);
/// Of the jumps among the components, in their order.
std::vector<std::size_t> momentsOf(const std::vector<Component>& components);

}  // namespace alidade
