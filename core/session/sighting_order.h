#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/session/session.h"

namespace alidade {

// The order of sightings: there and back, in one face and the other, or as in an earlier position. A stretch
// is a run of rows of one round and face.

/// The next row of a position, with only point, round and face. It continues the first order that exists: the
/// session's protocol (`protocol_progress.h`), until it is complete; another position that begins with the
/// same rows; pairs of faces at each place; the stretch before, forwards or backwards; the direction of the
/// last two points, and a new round where a way back ends at point 1. The first row of an empty position has
/// point 1. `chosen` as in `progressOf`.
Reading followingReading(const Session& session, std::size_t position,
                         std::optional<std::size_t> chosen = {});

/// The ways to prepare further rows before they are read.
enum class FurtherRows {
  WayBack,       ///< the places of the last stretch in reverse order, as the next round
  WayBackInTwo,  ///< as `WayBack`, in the other face
  AnotherRound,  ///< the places of the last stretch in the same order, as the next round
};

/// The rows to read after `rows`, with only point, round and face; empty if there are no rows.
std::vector<Reading> furtherRows(const std::vector<Reading>& rows, FurtherRows which);

/// Index of the first row of the last stretch.
std::size_t lastStretch(const std::vector<Reading>& rows);

}  // namespace alidade
