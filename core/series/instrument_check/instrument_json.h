#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// The document of `alidade-cli instrument --json`. Keys carry their units; missing values are null.
std::string instrumentJson(const CheckIdentity& identity, const InstrumentCheck& check,
                           const std::vector<Finding>& findings, const std::vector<std::string>& remarks);

/// A row for each face pair: station, round, target, residuals of direction and zenith angle, results of the
/// round, instrument and day.
std::string instrumentCsv(const CheckIdentity& identity, const InstrumentCheck& check);

}  // namespace alidade
