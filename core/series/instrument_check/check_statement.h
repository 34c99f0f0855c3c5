#pragma once

#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/instrument_check.h"
#include "core/statement/statement.h"

namespace alidade {

/// Whether s is at most its limit from the stated σ (question a of ISO 17123-3). Absent without a stated σ.
/// Also absent if only one of two circles has a stated σ and passes the test.
std::optional<bool> hasPassed(const InstrumentCheck& check);

/// The verdict: its title is the headline, "Passed: s of a direction 0.74″ (limit 1.23″), …"; its sentences
/// state its basis and the number of warnings.
Statement checkVerdict(const InstrumentCheck& check, const std::vector<Finding>& findings);

/// Instrument, serial number, day, and next check: a row for each, with a dash where it is not stated.
Statement identityTable(const CheckIdentity& identity);

/// A row for each station: scatter, means and causes. For several stations, the last row pools all.
Statement stationsTable(const InstrumentCheck& check);

/// The tables of the station by round and by target; none if one would have more than 40 rows.
std::vector<Statement> stationDetails(const StationCheck& station);

}  // namespace alidade
