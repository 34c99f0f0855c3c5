#pragma once

#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "core/series/history/value_table.h"

namespace alidade {

/// The JSON document of `alidade-cli history --json`, ending in a newline: null for what is no number.
/// `name` tells what it is of.
std::string historyJson(const std::string& name, const ValueTable& table, const History& history);

/// Of one device its intersection with all its quantities and congruences; of several a list of these under
/// `devices`. `remarks`: sentences about sessions that take no part.
std::string historyJson(const std::string& name, const DeviceHistories& histories,
                        const std::vector<std::string>& remarks);

}  // namespace alidade
