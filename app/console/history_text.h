#pragma once

#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "core/series/history/value_table.h"

namespace alidade::console {

/// `alidade-cli history` for people: the values with their control limits, and what they say.
std::string historyText(const std::string& name, const ValueTable& table, const History& history);

/// Of each device Δd with its table, every other quantity in a line, and the comparison of one session with
/// the next.
std::string historyText(const std::string& name, const DeviceHistories& histories);

}  // namespace alidade::console
