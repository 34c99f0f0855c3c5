#pragma once

#include <optional>
#include <string_view>

namespace alidade {

/// A moment such as `2026-03-01T10:12:13.5+01:00` (ISO 8601, a blank in place of the T, seconds and zone may
/// be missing: then 0 s, and the same zone for all), in minutes since 1970-01-01T00:00Z. Absent where the
/// text is no such moment.
std::optional<double> minutesOf(std::string_view text);

}  // namespace alidade
