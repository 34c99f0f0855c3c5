#pragma once

#include <string>

#include "core/base/angle.h"

namespace alidade {

/// A reading as an observer writes it: rounded to the step.
std::string typedAngle(Angle angle, const Angle& step);

/// A circle reading as an observer writes it: rounded, then wrapped into [0°, 360°).
std::string typedOnCircle(Angle angle, const Angle& step);

}  // namespace alidade
