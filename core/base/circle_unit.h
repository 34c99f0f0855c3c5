#pragma once

#include <string>

#include "core/base/angle.h"

namespace alidade {

/// The unit in which an instrument shows its circles.
enum class CircleUnit { Dms, Degrees, Gon };

/// A typed angle with the sign of `unit` where it is a bare number that means no angle, or another one,
/// without it: 341.8733 in degrees is 341.8733°, 379.8592 in gon is 379.8592gon. Anything else is as typed:
/// what has signs, separators or a unit of its own, and in degrees also digits run together (3415224).
std::string completedAngle(const std::string& typed, CircleUnit unit);

/// How finely an angle is written, as decimals of seconds; in degrees and gon these are four more, whose
/// fourth is 0.36″ and 0.32″. From 0 to 3: without trailing noughts, and to a tenth of a second where no
/// number of them ends it.
int decimalsOf(Angle angle, CircleUnit unit);

/// For reading, to `decimals` (0…9) of seconds: 341°52′24.5″, 341.87347°, 379.85941 gon.
std::string formatAngle(Angle angle, CircleUnit unit, int decimals);

}  // namespace alidade
