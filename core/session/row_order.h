#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"

namespace alidade {

/// The number of each position's first row among all rows of the session in the order taken, excluded ones
/// too. The position at 0° was taken first, whatever the order of the file; the others follow in that order.
std::vector<std::size_t> firstSequences(const Session& session);

}  // namespace alidade
