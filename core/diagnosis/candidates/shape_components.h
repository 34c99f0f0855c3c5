#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/candidates/component.h"

namespace alidade {

/// Smooth and periodic patterns along the guideway, with the instrument's circles, with time, and between
/// the positions, that no effect of the catalogue makes, or only one that is left out.
std::vector<Component> shapeComponents(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit, const std::vector<std::string>& leftOut,
                                       const PriorOdds& odds);

}  // namespace alidade
