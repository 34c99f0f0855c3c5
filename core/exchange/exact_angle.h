#pragma once

#include <optional>
#include <string>

namespace alidade {

/// An angle of an instrument's file in a notation of `parseAngle`, every digit kept.
struct ExactAngle {
  std::string text;
  bool isCarried = false;  ///< 60 seconds or minutes were written, which are the next minute or degree
};

/// Degrees, minutes and whole seconds as a file has them, with the decimals of the seconds.
struct SexagesimalParts {
  unsigned long long degrees = 0, minutes = 0, seconds = 0;
  std::string decimals = {};

  /// 60 seconds become the next minute and 60 minutes the next degree: instruments round 59.96″ to 60.0″.
  /// More than 60 stays as it is. True where something was carried.
  bool carry();
  /// A full turn becomes 0.
  void wrapFullTurn();
  /// `89 14 13.5`, or `89°14'13.5"` with the signs.
  std::string text(bool hasSigns) const;
};

/// Carried and wrapped, as a circle reads.
ExactAngle exactAngle(SexagesimalParts parts, bool hasSigns);

/// A plain number with a unit that an instrument names (gon, grd, deg, DMS, mil; capitals do not matter):
/// `34.9078` and `gon` as `34.9078gon`, `89.1413` and `DMS` as `89 14 13`, mil of 6400 to a turn exactly as
/// decimal degrees. A full turn (400 gon, 360°, 6400 mil) is 0, as on the circle. Absent where it is no
/// number or no such unit.
std::optional<ExactAngle> exactAngle(const std::string& number, const std::string& unit);

}  // namespace alidade
