#include "core/series/instrument_check/checked_readings.h"

#include <utility>

#include "core/series/instrument_check/plausibility.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

Result<InstrumentCheck> checkReadings(const CheckReadings& readings, const CheckOptions& options) {
  const std::vector<StationRounds> stations = completeRounds(readings);
  InstrumentCheck check = checkInstrument(stations, options);
  if (auto problem = implausibility(stations, check)) return *std::move(problem);
  return check;
}

}  // namespace alidade
