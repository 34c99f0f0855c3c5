#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/session/session.h"
#include "ui/jobs/guide.h"

namespace alidade::ui {

/// What is to be read next in a position.
struct NextReading {
  std::size_t row = 0;  ///< the first still to be read; the one after the last where all are
  Reading sighting;     ///< its point, round and face
  std::optional<ExpectedReading> expected = {};
};

/// Of every position, as the protocol has it where there is a `guide`, with the readings expected there where
/// `measurement` is not null; absent where it has all that another position has. Sessions of more rows than
/// anyone types are given none.
std::vector<std::optional<NextReading>> nextReadings(const Session& session, const Measurement* measurement,
                                                     const SessionFit& fit, const Guide* guide = nullptr);

}  // namespace alidade::ui
