#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

// The progress of a session in its protocol. Sightings may be taken in any order: position, point, round and
// face alone identify them.

/// One sighting of a protocol: of a place, or of a position's pointing zero.
struct PlannedSighting {
  std::size_t protocolPosition = 0;  ///< index into the protocol's positions
  int axisDeg = 0, repeat = 1;       ///< axis of the position, and repeat at that axis
  bool isZero = false;
  bool isAfter = false;  ///< the zero is sighted after the readings of its position
  int point = 0;         ///< point of a place; 0 for a zero
  int round = 1;         ///< round of a place; 1 for a zero
  int face = 1;
  std::size_t place = 0;  ///< index into the places of its position

  bool operator==(const PlannedSighting&) const = default;
};

/// All sightings of a protocol, in order.
std::vector<PlannedSighting> sightingsInOrder(const SightingProtocol& protocol);

/// The protocol that a session follows; absent if there is none, or if the rows depart from an `isYielding`
/// one. Fails, with the place in the session, if the protocol is invalid.
Result<std::optional<SightingProtocol>> protocolOf(const Session& session);

/// The minutes of the protocol that a session follows, or else the usual ones.
SightingMinutes sightingMinutesOf(const Session& session);

enum class SightingState {
  Taken,
  Next,      ///< to be taken now
  Missed,    ///< skipped: later sightings of its position exist
  Left,      ///< not yet reached
  Excluded,  ///< taken, but excluded from the fit: may be taken again
};

struct FollowedSighting {
  PlannedSighting planned;
  SightingState state = SightingState::Left;
  std::optional<std::size_t> position = {};  ///< index in the session; absent if the session lacks it
  /// Index of the sighting's row, even of an unread one; absent if there is none, and for a zero.
  std::optional<std::size_t> row = {};
  bool isOutOfTurn = false;  ///< taken after a sighting that follows it in the protocol
  bool isRepeated = false;   ///< read in several rows
};

/// Was the sighting taken, even if it is excluded?
inline bool isThere(const FollowedSighting& followed) {
  return followed.state == SightingState::Taken || followed.state == SightingState::Excluded;
}

struct ProtocolProgress {
  std::vector<FollowedSighting> sightings;  ///< in the order of the protocol
  std::size_t taken = 0, excluded = 0, missed = 0, outOfTurn = 0;
  std::size_t unplanned = 0;             ///< rows with readings that are not in the protocol
  std::optional<std::size_t> next = {};  ///< index into `sightings`; absent if the protocol is complete

  std::size_t left() const { return sightings.size() - taken - excluded; }
  bool isComplete() const { return left() == 0; }
};

/// The next sighting is the first that exists of these: a half-filled row; the first zero of a position with
/// readings but no zero; `chosen`, an index into the sightings of a protocol by worth; in the current
/// position, the first reading left after the last one taken, then a skipped reading, then a zero; the first
/// sighting left in the protocol. The current position is the last with any entry. No sighting of a protocol
/// by worth is missed or out of turn.
ProtocolProgress progressOf(const Session& session, const SightingProtocol& protocol,
                            std::optional<std::size_t> chosen = {});

/// The progress in the session's own protocol; absent without one, or with an invalid one.
std::optional<ProtocolProgress> progressIn(const Session& session, std::optional<std::size_t> chosen = {});

/// Index of the next sighting of a place in one position of the session; absent if none remains.
std::optional<std::size_t> nextPlaceIn(const ProtocolProgress& progress, std::size_t position);

/// The row for a sighting of a place, with only point, round and face.
Reading rowFor(const PlannedSighting& planned);

/// The field for a sighting of a zero: "pointing_zero", "pointing_zero.face_2", ….
std::string zeroField(const PlannedSighting& planned);
std::string zeroField(const ZeroSlot& slot);

/// Axes of the protocol's positions that the session lacks, in the order of the protocol.
std::vector<int> positionsLacking(const Session& session, const SightingProtocol& protocol);

}  // namespace alidade
