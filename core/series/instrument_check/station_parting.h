#pragma once

#include <vector>

#include "core/base/angle.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

/// Rounds whose targets differ by more are of different stations. Scatter, a knocked tripod and a centring
/// repeated at distances of work stay below it.
inline constexpr Angle leastBetweenStations = Angle::fromArcseconds(360);

/// The rounds of one station name, parted where groups of at least two rounds show the same targets at
/// different places: the file names no stations, or gives the name of a target to another one. The parts are
/// called `name (1)`, `name (2)`. Undivided where a group would hold a single round, which is as likely
/// misread, and where the horizontal circle counts in the opposite direction: `implausibility` refuses both.
std::vector<StationRounds> partedByGeometry(StationRounds station);

}  // namespace alidade
