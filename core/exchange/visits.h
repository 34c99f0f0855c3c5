#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/exchange/recording.h"
#include "core/session/session.h"

namespace alidade {

/// Identifies the position of a sighting: the axis, and the repeat at that axis.
using PositionKey = std::pair<std::string, int>;

PositionKey positionOf(const RecordedSighting& sighting);

/// `0°`, `0°, repeat 2`.
std::string nameOf(const PositionKey& key);

/// The position in the session; null if there is none.
const Position* positionIn(const Session& session, const PositionKey& key);

/// Assigns positions to the sightings. A return of the axis begins a new repeat, with its own pointing zeros,
/// if points are sighted again and no other round is stated. The rows of `base` precede the sightings; a
/// position of `base` without rows is filled next.
void takePositions(std::vector<RecordedSighting>& sightings, const Session& base);

/// Assigns a round to sightings without one: the first that neither the file nor `base` states for the point
/// and face in the position. True if an assigned round is above 1.
bool takeRounds(std::vector<RecordedSighting>& sightings, const Session& base);

}  // namespace alidade
