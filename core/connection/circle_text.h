#pragma once

#include <string>

#include "core/base/angle.h"
#include "core/base/circle_unit.h"
#include "core/session/measurement.h"

namespace alidade {

/// A circle reading for a session, to a thousandth of a second and without noughts at its end: finer than any
/// circle, coarser than the last digits of radians.
std::string circleText(Angle reading, CircleUnit unit);

/// A zenith angle in [0°, 360°) as a circle of that kind reads it; see `isFaceTwo`.
Angle onCircle(Angle zenith, VerticalCircle circle);
/// And back.
Angle zenithOf(Angle reading, VerticalCircle circle);

}  // namespace alidade
