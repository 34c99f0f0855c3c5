#pragma once

#include <string>

#include "core/series/history/device_history.h"
#include "core/series/history/record_history.h"
#include "core/statement/statement.h"

namespace alidade {

// Tables and sentences of a history; invisible characters of user texts are escaped (`visibleText`). They are
// in this folder because the folder of the other statements must not depend on histories.

/// Each value with U, Shewhart limits, and the exponentially weighted average with limits; then sentences.
Statement valueTable(const History& history, const std::string& unit);
/// Each session with Δd, measured, and its verdict; below each row, the condition of the verdict.
Statement sessionTable(const DeviceHistory& device);
/// Each quantity of the device: its weighted mean, χ², trend and course.
Statement quantityTable(const DeviceHistory& device);
/// Each session compared with the next, and the first with the last.
Statement congruenceTable(const DeviceHistory& device);

/// Each record of the instrument with its due date, and whether the next check is late on `today`,
/// year-month-day. Below them, the values that are left out.
Statement recordTable(const InstrumentHistory& instrument, const std::string& today);

/// The conclusions from a quantity's history, in one or two sentences each.
std::vector<std::string> quantitySentences(const DeviceHistory& device, const QuantityHistory& quantity);

/// "Guideway 7, serial number G-07".
std::string deviceName(const DeviceHistory& device);
/// Name and serial number of an instrument, in the form of `deviceName`.
std::string instrumentName(const InstrumentHistory& instrument);
/// "0.19 mm ± 0.23 mm": Δd, measured, and its expanded uncertainty.
std::string intersectionText(const Epoch& epoch);

}  // namespace alidade
