#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace alidade {

/// A typed day as year-month-day if it is unambiguous: 2026/3/1, 20260301, 1.3.2026 (with dots the day comes
/// first), 1 Mar 2026, March 1, 2026, 2026年3月1日. 13/2/2026 and 2/13/2026 are unambiguous: 13 cannot be a
/// month. Other texts, such as 3/4/2026 or a day that does not exist, are returned as typed.
std::string completedDay(const std::string& typed);

/// Whether the entry with this key in the session file is a day, to be completed by `completedDay`.
bool isDay(std::string_view key);

/// A moment such as `2026-03-01T10:12:13.5+01:00` (ISO 8601) in minutes since 1970-01-01T00:00Z. A blank may
/// replace the T; missing seconds are 0, and a missing zone counts as UTC. Absent for other texts.
std::optional<double> minutesOf(std::string_view text);

}  // namespace alidade
