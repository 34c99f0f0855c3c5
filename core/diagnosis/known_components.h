#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/component.h"

namespace alidade {

// The causes that have a name. For the .cpp files of this room only.

/// Another relation between y and e holds altogether or not at all.
bool isAllOrNothing(const Effect& effect);
/// The effects of the catalogue but those in `leftOut`.
std::vector<Component> effectComponents(const Leftover& leftover, const std::vector<std::string>& leftOut,
                                        const PriorOdds& odds);
/// A step before any row; of long sessions before every so manieth. One that a single row alone in its visit
/// would show leaves what a misreading of that row leaves, which is the commoner: it is for comparison only.
std::vector<Component> jumpComponents(const Leftover& leftover, const PriorOdds& odds);
/// Of the jumps among the components, in their order.
std::vector<std::size_t> momentsOf(const std::vector<Component>& components);

}  // namespace alidade
