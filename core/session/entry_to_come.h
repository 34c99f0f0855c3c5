#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/session/protocol_progress.h"
#include "core/session/session.h"

namespace alidade {

/// What is to be typed next: a pointing zero or a row.
struct EntryToCome {
  std::size_t position = 0;
  std::string zero = {};  ///< "pointing_zero", "pointing_zero.face_2", …; empty: a row
  std::size_t row = 0;    ///< the first still to be read; the one behind the last where all are
  Reading sighting = {};  ///< point, round and face of the row
  int zeroFace = 1;       ///< of a zero
  bool isAfter = false;   ///< of a zero: behind the readings
};

/// While one types at position `here`: as the protocol has it where there is a `progress`. Else what was
/// begun comes first: a row that is half filled, then the pointing zero of a position that has readings or
/// half a zero, `here` before the others; then what is left `here`, and once it has all that another position
/// has, what is left elsewhere. Absent where nothing is left.
std::optional<EntryToCome> entryToCome(const Session& session, std::size_t here,
                                       const ProtocolProgress* progress = nullptr);

/// The same, with the progress in the protocol that the session follows.
std::optional<EntryToCome> entryToComeOf(const Session& session, std::size_t here);

/// Has one circle been typed and the other not?
bool isHalfFilled(const Reading& row);

/// Has the position all the places that another position has?
bool hasAllOfAnother(const Session& session, std::size_t position);

}  // namespace alidade
