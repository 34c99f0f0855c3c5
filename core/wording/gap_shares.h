#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// What a division of the gap is by: "belongs to", "axis at", "along the arc", "face".
std::string divisionName(const GapShare& share);

/// The part of the division: "guideway", "180°", "0° again", "2nd quarter", "the radii", "30…60°".
std::string partName(const GapShare& share);

}  // namespace alidade
