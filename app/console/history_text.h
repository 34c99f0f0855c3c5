#pragma once

#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "core/series/history/record_history.h"
#include "core/series/history/value_table.h"

namespace alidade::console {

/// `alidade-cli history` as text: the values with their control limits, and the conclusions.
std::string historyText(const std::string& name, const ValueTable& table, const History& history);

/// Returns the history of each device: Δd with its table, every other quantity in a line, and each session
/// compared with the next.
std::string historyText(const std::string& name, const DeviceHistories& histories);

/// Returns the records of each instrument with their due dates, and each of its constants.
std::string historyText(const std::string& name, const InstrumentHistories& histories,
                        const std::string& today);

}  // namespace alidade::console
