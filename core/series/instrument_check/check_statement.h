#pragma once

#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/instrument_check.h"
#include "core/statement/statement.h"

namespace alidade {

/// Is s no larger than the stated σ (question a of ISO 17123-3)? Absent if no σ is stated for the circles
/// that were read. Also absent if σ is stated for only one of two circles, and this one passes.
std::optional<bool> hasPassed(const InstrumentCheck& check);

/// The verdict: its title is the headline, "Passed: s of a direction 0.74″ (limit 1.23″), …"; its sentences
/// state its basis and the number of warnings.
Statement checkVerdict(const InstrumentCheck& check, const std::vector<Finding>& findings);

/// Instrument, serial number, day, and next check: a row for each, with a dash where it is not stated.
Statement identityTable(const CheckIdentity& identity);

/// Each station with its scatter, means and causes, then all of them pooled. Without rows: the columns.
Statement stationsTable(const InstrumentCheck& check);

/// The station by round and by target; empty if a table would have more than 40 rows.
std::vector<Statement> stationDetails(const StationCheck& station);

}  // namespace alidade
