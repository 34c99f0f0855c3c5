#pragma once

#include <string>
#include <string_view>

#include "core/base/angle.h"
#include "core/base/result.h"

namespace alidade {

/// Reads an angle as people write and type it. These notations are accepted, with an optional leading sign
/// (+, - or −), a point or comma as decimal sign, and blanks anywhere between the parts:
///
///   with signs: 341°52'24", 341°52′24.5″, 341°52', 341°, 341度52分24秒; the signs may be ° º ˚ ◦ ∘ ⁰ for
///     degrees, ' ′ ’ ´ ` ʹ for minutes, and " ″ ” “ ʺ or two primes for seconds
///   with one kind of separator: 341 52 24, 341-52-24.5, 341:52:24, 341/52/24, 341.52.24
///   5 to 7 consecutive digits, as on a number pad: 3415224, 3415224.5, 881649
///   whole degrees, at most three digits: 341
///   decimal degrees with their unit: 341.873333°, 341.873333deg
///   gon with their unit: 379.859gon, 379.859g
///
/// Minutes and seconds are in [0, 60); only the last part may have decimals. A bare decimal such as
/// `341.5224` may mean degrees or degrees.minutes-seconds: it is refused, as are `341 52` and four digits.
/// Fullwidth digits and signs of input methods are read as their ASCII forms; digits of other scripts are
/// refused. The value is not wrapped and its range is not checked.
Result<Angle> parseAngle(std::string_view text);

enum class AngleSigns {
  Typewriter,  ///< 341°52'24", as in session files
  Primes,      ///< 341°52′24″, for display
};

/// Degrees, minutes and seconds with `decimals` (0…9) places of seconds, rounded so that all parts stay below
/// 60: 59.96″ with one decimal is 1′00.0″. Minutes and seconds have two digits. Negative angles have one
/// leading − (a hyphen with Typewriter). The angle is not wrapped: wrap circle readings first.
std::string formatDms(Angle angle, int decimals = 0, AngleSigns signs = AngleSigns::Primes);

/// Are the angles equal modulo 360° to within 10⁻⁶ arcseconds, the rounding of their texts?
bool areEqualAsTyped(Angle a, Angle b);

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
/// The same for a circle reading, in [0°, 360°): 359°59′59.99″ with one decimal is 0°00′00.0″.
std::string formatCircleReading(Angle reading, CircleUnit unit, int decimals);

}  // namespace alidade
