#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/component.h"

namespace alidade {

/// For the .cpp files of this room only. Smooth and periodic patterns along the guideway, with the
/// instrument's circles, with time, and between the positions, that no effect of the catalogue makes, or only
/// one that is left out.
std::vector<Component> shapeComponents(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit, const std::vector<std::string>& leftOut,
                                       const PriorOdds& odds);

}  // namespace alidade
