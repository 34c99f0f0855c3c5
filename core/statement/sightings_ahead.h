#pragma once

#include "core/diagnosis/sightings_ahead.h"
#include "core/statement/statement.h"

namespace alidade {

/// "For U = 0.10 mm of Δd: 22 more sightings in 31 min.", with the sightings of each position in a row. If U
/// is not reached: the U that these sightings reach, and what would reduce U further.
Statement sightingsAheadStatement(const SightingsAhead& ahead, double uncertainty);

}  // namespace alidade
