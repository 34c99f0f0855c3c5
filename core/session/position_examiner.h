#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/measurement.h"
#include "core/session/zero_examiner.h"

namespace alidade {

// The examination of one position of a session.

struct ExaminedPosition {
  std::vector<Sighting> sightings;  ///< sightings of the usable rows
  std::vector<Problem> problems;    ///< problems in the order of the file, except those of the axis
};

/// `index`: of the position in the session. `firstSequence`: of the position's first row (`firstSequences`).
/// `circle`: absent if unknown. Without `circle` or `zero`, rows are examined but there are no sightings.
ExaminedPosition examinePosition(const Position& position, std::size_t index, std::size_t firstSequence,
                                 const ExaminedZero& zero, const std::optional<VerticalCircle>& circle);

}  // namespace alidade
