#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/exchange/recording.h"
#include "core/session/session.h"

namespace alidade {

/// Which position a sighting is of: the axis, and the how many-th position at it.
using PositionKey = std::pair<std::string, int>;

PositionKey positionOf(const RecordedSighting& sighting);

/// `0°`, `0°, time 2`.
std::string nameOf(const PositionKey& key);

/// The position of the session; null where it has none such.
const Position* positionIn(const Session& session, const PositionKey& key);

/// Where the axis comes back and places are sighted that were sighted there before, with nothing that calls
/// it another round, the position is measured again, and the pointing zeros of that turn are its own. The
/// rows of `base` came before; a position of it without rows is the next to be filled.
void takePositions(std::vector<RecordedSighting>& sightings, const Session& base);

/// Where the file says no round, the first that neither it nor `base` states for this point and face of the
/// position. True: some are further rounds.
bool takeRounds(std::vector<RecordedSighting>& sightings, const Session& base);

}  // namespace alidade
