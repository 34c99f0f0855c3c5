#pragma once

#include <optional>
#include <string>

namespace alidade {

/// An angle from an instrument's file in a notation of `parseAngle`, with every digit of the file.
struct ExactAngle {
  std::string text;
  bool isCarried = false;  ///< 60 seconds or minutes were written and carried
};

/// Degrees, minutes and whole seconds as in a file, with the decimals of the seconds.
struct SexagesimalParts {
  unsigned long long degrees = 0, minutes = 0, seconds = 0;
  std::string decimals = {};

  /// Carries 60 seconds and 60 minutes: instruments round 59.96″ to 60.0″. Larger values stay unchanged. True
  /// if something was carried.
  bool carry();
  /// Replaces a full turn by 0.
  void wrapFullTurn();
  /// `89 14 13.5`, or `89°14'13.5"` with the signs.
  std::string text(bool hasSigns) const;
};

/// The angle after carrying and wrapping, as a circle reads.
ExactAngle exactAngle(SexagesimalParts parts, bool hasSigns);

/// Converts a plain number with a unit that an instrument names (gon, grd, deg, DMS, mil, in any case):
/// `34.9078` and `gon` become `34.9078gon`, `89.1413` and `DMS` become `89 14 13`, mil of 6400 to a turn
/// become exact decimal degrees. A full turn (400 gon, 360°, 6400 mil) is 0, as on the circle. Absent for
/// other texts and units.
std::optional<ExactAngle> exactAngle(const std::string& number, const std::string& unit);

}  // namespace alidade
