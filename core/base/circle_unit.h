#pragma once

#include <string>

#include "core/base/angle.h"

namespace alidade {

/// The unit in which an instrument shows its circles.
enum class CircleUnit { Dms, Degrees, Gon };

/// A typed angle with the sign of `unit` added if it is a bare number that would otherwise be refused or read
/// in another unit: 341.8733 in degrees is 341.8733°, 379.8592 in gon is 379.8592gon. Other texts stay as
/// typed: those with signs, separators or a unit, and in degrees also consecutive digits (3415224).
std::string completedAngle(const std::string& typed, CircleUnit unit);

/// The fewest decimals of seconds, 0 to 3, that write the angle exactly; 1 if three are not enough. Degrees
/// and gon have four decimals more than seconds: their fourth decimal is 0.36″ and 0.32″.
int decimalsOf(Angle angle, CircleUnit unit);

/// Formats an angle for display, to `decimals` (0…9) of seconds: 341°52′24.5″, 341.87347°, 379.85941 gon.
std::string formatAngle(Angle angle, CircleUnit unit, int decimals);

}  // namespace alidade
