#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "core/statement/statement.h"

namespace alidade {

/// Names the place of an entry.
using JournalPlaceNamer = std::function<std::string(const JournalEntry&)>;

/// The last `most` recorded changes of a session, oldest first, with `summary` (`journalSummary`) as a
/// sentence. A reason stated later is in the row of its change. Texts are cut to 64 characters, the length of
/// a digest; the origin of an import is cut to 1000.
Statement journalTable(const Session& session, const std::string& summary, const JournalPlaceNamer& nameOf,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace alidade
