#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

// How far a session has come in the protocol it follows. Sightings may be taken in any order: what is there
// is told by position, point, round and face alone.

/// One sighting of a protocol: of a place, or of a position's pointing zero.
struct PlannedSighting {
  std::size_t protocolPosition = 0;  ///< index into the protocol's positions
  int axisDeg = 0, time = 1;         ///< of the position: the how many-th at this axis
  bool isZero = false;
  bool isAfter = false;  ///< of a zero: behind the readings of its position
  int point = 0;         ///< of a place; with a zero 0
  int round = 1;         ///< likewise; of a zero 1
  int face = 1;
  std::size_t place = 0;  ///< index into the places of its position

  bool operator==(const PlannedSighting&) const = default;
};

/// All of a protocol, in its order.
std::vector<PlannedSighting> sightingsInOrder(const SightingProtocol& protocol);

enum class SightingState {
  Taken,
  Next,      ///< to be taken now
  Missed,    ///< passed over: sightings behind it in its position are there
  Left,      ///< still to come
  Excluded,  ///< taken, and kept out of the fit: to be taken again where it is wanted
};

struct FollowedSighting {
  PlannedSighting planned;
  SightingState state = SightingState::Left;
  std::optional<std::size_t> position = {};  ///< of the session; absent: it lacks the position
  /// Its row, the first still to be read where none is: absent where it has none yet, and of a zero.
  std::optional<std::size_t> row = {};
  bool isOutOfTurn = false;  ///< taken behind one that the protocol has later
};

struct ProtocolProgress {
  std::vector<FollowedSighting> sightings;  ///< in the order of the protocol
  std::size_t taken = 0, excluded = 0, missed = 0, outOfTurn = 0;
  std::size_t beside = 0;                ///< rows read that the protocol does not have
  std::optional<std::size_t> next = {};  ///< index into `sightings`; absent where nothing is left

  std::size_t left() const { return sightings.size() - taken - excluded; }
  bool isComplete() const { return left() == 0; }
};

/// The next sighting is a row that is half filled, then the first zero of a position that has readings
/// without it; else the first still to be taken behind the last one there of the position that is being read,
/// then what was passed over there, then the first of all. A position is being read that is the last with
/// anything in it, as long as it is not complete.
ProtocolProgress progressOf(const Session& session, const SightingProtocol& protocol);

/// Of the places of one position the one to be sighted next; absent where nothing is left of it there.
std::optional<std::size_t> nextPlaceIn(const ProtocolProgress& progress, std::size_t position);

/// The next sighting of a session, where it follows a protocol of which anything is left.
std::optional<FollowedSighting> nextSighting(const Session& session);

/// The row of a sighting of a place, with point, round and face alone.
Reading rowFor(const PlannedSighting& planned);

/// "pointing_zero", "pointing_zero.face_2", … of a sighting of a zero.
std::string zeroField(const PlannedSighting& planned);
std::string zeroField(const ZeroSlot& slot);

/// Positions that the protocol has and the session lacks, with their axes, in the order of the protocol.
std::vector<int> positionsLacking(const Session& session, const SightingProtocol& protocol);

}  // namespace alidade
