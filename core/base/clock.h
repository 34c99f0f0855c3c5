#pragma once

#include <string>

namespace alidade {

/// The present time in UTC: `2026-03-14T14:09:26Z`.
std::string timeInUtc();

/// The present local date: `2026-03-14`.
std::string localDay();

}  // namespace alidade
