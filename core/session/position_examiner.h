#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/measurement.h"

namespace alidade {

// One position of a session examined.

/// The pointing zero of one position, α0 and β0 of face 1.
struct ZeroDirection {
  Angle horizontal, vertical;
};

struct ExaminedPosition {
  std::optional<ZeroDirection> zero;  ///< absent where it cannot be used
  std::vector<Sighting> sightings;    ///< of the rows that can
  std::vector<Problem> problems;      ///< in the order of the file; not those of the axis
};

/// `index` among the session's positions, `firstSequence` that of its first row (`firstSequences`). `circle`:
/// absent where nobody knows, and then nothing can be reduced.
ExaminedPosition examinePosition(const Position& position, std::size_t index, std::size_t firstSequence,
                                 const std::optional<VerticalCircle>& circle);

}  // namespace alidade
