#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// A circle reading from a file, converted to a notation of `parseAngle`.
struct FileAngle {
  std::string text;
  bool isCarried = false;     ///< minutes or seconds were 60, or 100 in gon, and were carried
  bool isFullCircle = false;  ///< 360° or 400 gon, the zero of the circle
};

/// Joins degrees, minutes and seconds from separate cells into one text, `17 41 33`; the seconds are empty if
/// the table has none. A sign holds for the whole angle, as in −0 12 30. Minutes and seconds of 60 carry.
/// Parts may have their own marks (17° 41' 33"). Whole parts may have zeros as decimals. `isCentesimal`: the
/// parts are gon, 1/100 gon and 1/10000 gon, carried at 100; 17 41 33 becomes 17.4133gon.
Result<FileAngle> joinedAngle(const std::array<std::string_view, 3>& parts, bool hasSeconds,
                              bool isCentesimal);

/// Normalises the text of one cell: 107°12'60" becomes 107 13 00, 360° becomes 0°. Any other text is returned
/// unchanged, even if it is not an angle.
FileAngle angleOfFile(std::string text);

}  // namespace alidade
