#pragma once

#include "core/diagnosis/sightings_ahead.h"
#include "core/statement/statement.h"

namespace alidade {

/// "For U = 0.1 mm of Δd, whatever effect is there: 22 more sightings in 31 min.", with a row of points for
/// each position in turn. If U (`uncertainty`, mm) is not reached: the U reached, and what reduces U further.
Statement sightingsAheadStatement(const SightingsAhead& ahead, double uncertainty);

}  // namespace alidade
