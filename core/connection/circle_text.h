#pragma once

#include <string>

#include "core/base/angle.h"
#include "core/base/circle_unit.h"
#include "core/session/measurement.h"

namespace alidade {

/// A circle reading for a session, to a thousandth of an arcsecond and without trailing zeros: finer than any
/// circle, coarser than the last digits of radians.
std::string circleText(Angle reading, CircleUnit unit);

/// A zenith angle in [0°, 360°) as a circle of this kind reads it; see `isFaceTwo`.
Angle onCircle(Angle zenith, VerticalCircle circle);
/// The inverse of `onCircle`.
Angle zenithOf(Angle reading, VerticalCircle circle);

}  // namespace alidade
