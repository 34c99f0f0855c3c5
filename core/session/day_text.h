#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// A typed day as year-month-day if it is unambiguous: 2026/3/1, 20260301, 1.3.2026 (with dots the day comes
/// first), 1 Mar 2026, March 1, 2026, 2026年3月1日. 13/2/2026 and 2/13/2026 are unambiguous: 13 cannot be a
/// month. Other texts, such as 3/4/2026 or a day that does not exist, are returned as typed.
std::string completedDay(const std::string& typed);

/// Is the entry with this key in the session file a day?
bool isDay(std::string_view key);

}  // namespace alidade
