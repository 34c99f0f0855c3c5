#pragma once

#include <vector>

#include "core/base/angle.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

/// Rounds whose targets differ by more than this angle belong to different stations. Scatter, a knocked
/// tripod and repeated centring at working distances stay below it.
inline constexpr Angle leastBetweenStations = Angle::fromArcseconds(360);

/// Splits the rounds of one station name if groups of at least two rounds show the same targets at different
/// places: the file names no stations, or two targets share a name. The parts are called `name (1)`, `name
/// (2)`. Rounds stay together if a group would have only one round, as its readings may be wrong. Rounds also
/// stay together if the horizontal circle counts in opposite directions. `implausibility` refuses both cases.
std::vector<StationRounds> partedByGeometry(StationRounds station);

}  // namespace alidade
