#pragma once

#include <vector>

#include "core/diagnosis/component.h"
#include "core/diagnosis/explanation.h"

namespace alidade {

/// For the .cpp files of this room only. 1 − rms after/rms before, arcseconds over the circle readings, when
/// every fifth visit in turn is kept out of the fit of unknowns and causes, and then predicted.
double heldOutShrinkage(const Leftover& leftover, const Explanation& explanation,
                        const std::vector<Component>& candidates);

}  // namespace alidade
