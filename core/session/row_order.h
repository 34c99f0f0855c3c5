#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"

namespace alidade {

/// Indices of the session's positions in the order taken: in file order if an axis repeats, else by
/// the clock if the first row of each has a time, else 0° first.
std::vector<std::size_t> positionsAsTaken(const Session& session);

/// The index of each position's first row among all rows of the session in the order taken. Excluded rows
/// count.
std::vector<std::size_t> firstSequences(const Session& session);

}  // namespace alidade
