#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/measurement.h"
#include "core/session/zero_examiner.h"

namespace alidade {

// One position of a session examined.

struct ExaminedPosition {
  std::vector<Sighting> sightings;  ///< of the rows that can be used
  std::vector<Problem> problems;    ///< in the order of the file; not those of the axis
};

/// `index` among the session's positions, `firstSequence` that of its first row (`firstSequences`). `circle`:
/// absent where nobody knows, and then nothing can be reduced; nor without a `zero`.
ExaminedPosition examinePosition(const Position& position, std::size_t index, std::size_t firstSequence,
                                 const ExaminedZero& zero, const std::optional<VerticalCircle>& circle);

}  // namespace alidade
