#pragma once

#include <string>

namespace alidade::console {

/// Now, in UTC: `2026-03-14T14:09:26Z`.
std::string timeInUtc();

/// Today, where the computer is: `2026-03-14`.
std::string localDay();

}  // namespace alidade::console
