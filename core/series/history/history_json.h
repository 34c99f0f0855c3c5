#pragma once

#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "core/series/history/record_history.h"
#include "core/series/history/value_table.h"

namespace alidade {

/// The JSON document of `alidade-cli history --json`, ending in a newline; missing numbers are null. `name`
/// says what the document describes.
std::string historyJson(const std::string& name, const ValueTable& table, const History& history);

/// For one device, the document holds the history of Δd with all quantities and congruences. For several
/// devices, `devices` lists this content for each device. `remarks`: sentences about excluded sessions.
std::string historyJson(const std::string& name, const DeviceHistories& histories,
                        const std::vector<std::string>& remarks);

/// The records of each instrument, and the history of each of its constants.
std::string historyJson(const std::string& name, const InstrumentHistories& histories,
                        const std::vector<std::string>& remarks);

}  // namespace alidade
