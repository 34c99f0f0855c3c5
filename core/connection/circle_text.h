#pragma once

#include <string>

#include "core/base/angle.h"
#include "core/base/angle_text.h"
#include "core/session/measurement.h"

namespace alidade {

/// The text of a circle reading for a session, without trailing zeros. Its resolution, finer than that of any
/// circle, is 0.001″ with minutes and seconds, 10⁻⁷° in decimal degrees, and 10⁻⁷ gon.
std::string circleText(Angle reading, CircleUnit unit);

/// The reading of this kind of vertical circle at the zenith angle `zenith` in [0°, 360°); see `isFaceTwo`.
Angle onCircle(Angle zenith, VerticalCircle circle);
/// The inverse of `onCircle`.
Angle zenithOf(Angle reading, VerticalCircle circle);

}  // namespace alidade
