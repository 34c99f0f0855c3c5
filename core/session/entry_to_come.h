#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/session/protocol_progress.h"
#include "core/session/session.h"

namespace alidade {

/// The next entry to type: a field of the session, a pointing zero or a row.
struct EntryToCome {
  std::string field = {};  ///< "geometry.distance_mm" or "geometry.radius_mm" alone; empty: a zero or a row
  std::size_t position = 0;
  std::string zero = {};  ///< "pointing_zero", "pointing_zero.face_2", …; empty: a row
  std::size_t row = 0;    ///< the first unread row; one past the last if all are read
  Reading sighting = {};  ///< point, round and face of the row
  int zeroFace = 1;       ///< face of the zero
  bool isAfter = false;   ///< the zero is sighted after the readings
};

/// The next entry while position `here` is being typed. With a `progress`, it is the protocol's next
/// sighting. Otherwise begun entries come first: a half-filled row, then the pointing zero of a position that
/// has readings or half a zero. Then follow missing entries; a position is complete if `hasAllOfAnother`. In
/// each step `here` comes before the other positions. Absent if nothing remains.
std::optional<EntryToCome> entryToCome(const Session& session, std::size_t here,
                                       const ProtocolProgress* progress = nullptr);

/// The next entry, with the progress in the session's protocol. `chosen` as in `progressOf`.
std::optional<EntryToCome> entryToComeOf(const Session& session, std::size_t here,
                                         std::optional<std::size_t> chosen = {});

/// The entry to lead a person to. An empty distance or nominal radius comes before all others. Without a
/// protocol, another position's missing pointing zero comes before a fourth or later row of an arc: a zero
/// typed into that row would count as a reading.
std::optional<EntryToCome> entryToLeadTo(const Session& session, std::size_t here,
                                         const ProtocolProgress* progress);
std::optional<EntryToCome> entryToLeadTo(const Session& session, std::size_t here,
                                         std::optional<std::size_t> chosen = {});

/// Is only one of the two circles typed?
bool isHalfFilled(const Reading& row);

/// Are the points, rounds and faces of the position's rows those of some other position, in the same order?
bool hasAllOfAnother(const Session& session, std::size_t position);

}  // namespace alidade
