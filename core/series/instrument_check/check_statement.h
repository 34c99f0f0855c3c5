#pragma once

#include <vector>

#include "core/series/instrument_check/instrument_check.h"
#include "core/statement/statement.h"

namespace alidade {

/// Each station with its scatter, means and causes, then all of them pooled. Without rows: the columns.
Statement stationsTable(const InstrumentCheck& check);

/// The station by round and by target; empty if a table would have more than 40 rows.
std::vector<Statement> stationDetails(const StationCheck& station);

}  // namespace alidade
