#pragma once

#include <string>

#include "core/session/session.h"

namespace alidade {

/// The rows of a session as a table that `importReadings` reads back to the same measurement. Entries are as
/// typed; an empty point, round or face becomes its meaning. The column of the vertical circle is called
/// `zenith` or `elevation`. The sightings of a pointing zero are rows of the point ZERO before and after the
/// rows of their position, as taken. An import replaces several zeros of a position by their mean. If an axis
/// repeats, a column `turn` counts its positions. Data from the instrument, if there is any, has columns of
/// its own, which an import reads for rows but not for a pointing zero. Rows without any entry, the journal
/// and first texts are left out.
std::string readingsCsv(const Session& session);

}  // namespace alidade
