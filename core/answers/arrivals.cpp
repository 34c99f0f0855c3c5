#include "core/answers/arrivals.h"

#include <algorithm>
#include <utility>

namespace alidade {

std::vector<Arrival> arrivalsOf(const Session& session) {
  std::vector<Arrival> arrivals;
  for (std::size_t position = 0; position < session.positions.size(); ++position) {
    const std::vector<Reading>& rows = session.positions[position].readings;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const Reading& reading = rows[row];
      if (!reading.takenAt.empty() || !reading.returnCode.empty() || !reading.instrumentSerial.empty())
        arrivals.push_back({position, row, reading.takenAt, reading.returnCode, reading.instrumentSerial});
    }
  }
  return arrivals;
}

const Arrival* arrivalAt(const std::vector<Arrival>& arrivals, std::size_t position, std::size_t row) {
  const auto placeOf = [](const Arrival& arrival) { return std::pair(arrival.position, arrival.row); };
  const auto found = std::ranges::lower_bound(arrivals, std::pair(position, row), {}, placeOf);
  return found != arrivals.end() && placeOf(*found) == std::pair(position, row) ? &*found : nullptr;
}

}  // namespace alidade
