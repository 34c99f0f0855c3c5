#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// What is done to the reading of a circle in a file so that it is one of `parseAngle`.
struct FileAngle {
  std::string text;
  bool isCarried = false;     ///< minutes or seconds of 60 are the next degree or minute
  bool isFullCircle = false;  ///< 360° or 400 gon, which is the zero of the circle
};

/// Degrees, minutes and seconds from cells of their own as one text, `17 41 33`; the seconds are empty where
/// the table has none. A sign holds for all of the angle, −0 12 30 too. Minutes and seconds of 60 carry.
/// Parts may have their own signs (17° 41' 33"), and noughts for decimals where they are whole.
/// `isCentesimal`: gon with their hundredths and those of these, 17 41 33 as 17.4133gon.
Result<FileAngle> joinedAngle(const std::array<std::string_view, 3>& parts, bool hasSeconds,
                              bool isCentesimal);

/// The text of one cell: 107°12'60" as 107 13 00, 360° as 0°. Everything else stays, also what is no angle.
FileAngle angleOfFile(std::string text);

}  // namespace alidade
