#pragma once

#include <string>

#include "core/series/history/device_history.h"
#include "core/statement/statement.h"

namespace alidade {

// Tables of a history, and its sentences; user texts are visible (`visibleText`). They stand here since a
// history comes after the room of statements.

/// Each value with U, its limit, the weighted average and its limit; below them the sentences.
Statement valueTable(const History& history, const std::string& unit);
/// Each session of the device with Δd, measured, and its verdict.
Statement sessionTable(const DeviceHistory& device);
/// Each quantity of the device: its weighted mean, χ², trend and course.
Statement quantityTable(const DeviceHistory& device);
/// Each session compared with the next, and the first with the last.
Statement congruenceTable(const DeviceHistory& device);

/// The conclusions from a quantity's history, in one or two sentences each.
std::vector<std::string> quantitySentences(const DeviceHistory& device, const QuantityHistory& quantity);

/// "Guideway 7, serial number G-07".
std::string deviceName(const DeviceHistory& device);
/// "accept"; empty without a tolerance.
std::string verdictWord(const Epoch& epoch);
/// "0.185 mm ± 0.226 mm": Δd, measured, and its expanded uncertainty.
std::string intersectionText(const Epoch& epoch);

}  // namespace alidade
