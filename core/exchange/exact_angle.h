#pragma once

#include <optional>
#include <string>

namespace alidade {

/// A plain number with a unit that an instrument names (gon, grd, deg, DMS, mil; capitals do not matter) in a
/// notation of `parseAngle`, every digit kept: `34.9078` and `gon` as `34.9078gon`, `89.1413` and `DMS` as
/// `89 14 13`, mil of 6400 to a turn exactly as decimal degrees. Absent where it is no number or no such
/// unit.
std::optional<std::string> exactAngle(const std::string& number, const std::string& unit);

}  // namespace alidade
