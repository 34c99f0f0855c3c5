#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/evaluation/guide.h"
#include "core/session/session.h"

namespace alidade {

/// The next reading of a position.
struct NextReading {
  std::size_t row = 0;  ///< the first unread row; the one after the last if all are read
  Reading sighting;     ///< point, round and face of that row
  std::optional<ExpectedReading> expected = {};
};

/// The next reading of every position, following the protocol if there is a `guide`. Includes expected
/// readings if `measurement` is not null. Absent for a position that is complete by the protocol or, without
/// a protocol, has every sighting of another position. Empty for sessions of more than 10 000 rows.
std::vector<std::optional<NextReading>> nextReadings(const Session& session, const Measurement* measurement,
                                                     const SessionFit& fit, const Guide* guide = nullptr);

}  // namespace alidade
