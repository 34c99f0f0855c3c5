#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"

namespace alidade {

// In which order places are sighted: there and back, in one face and the other, as an earlier position was.
// A stretch is a run of rows of one round and face.

/// The row that would follow those of a position, with point, round and face alone: as the protocol has it
/// that the session follows (`protocol_progress.h`), until all of that is there; else as in another position
/// that begins as this one does; else each place in both faces, where the last ones were; else as the stretch
/// before in its order or the reverse; else the next point in the direction of the last two (point 1 of an
/// empty position).
Reading followingReading(const Session& session, std::size_t position);

/// How rows are laid out before they are read.
enum class FurtherRows {
  WayBack,       ///< the places of the last stretch from its end, as the next round
  WayBackInTwo,  ///< likewise, in the other face
  AnotherRound,  ///< the places of the last stretch in its order, as the next round
};

/// The rows to be read after `rows`, with point, round and face alone; none where there are no rows.
std::vector<Reading> furtherRows(const std::vector<Reading>& rows, FurtherRows which);

/// Index of the first row of the last stretch.
std::size_t lastStretch(const std::vector<Reading>& rows);

}  // namespace alidade
