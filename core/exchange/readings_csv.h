#pragma once

#include <string>

#include "core/session/session.h"

namespace alidade {

/// The rows of a session as a table that `importReadings` reads back to the same measurement: every entry as
/// typed, and what an empty point, round or face stands for. The column of the vertical circle is called
/// `zenith` or `elevation`. The sightings of a pointing zero are rows of the point ZERO before and after
/// those of their position, as they were taken; an import takes several in a position as their mean. Where an
/// axis comes again, a column `turn` counts its positions. What came with rows from the instrument has
/// columns of its own where anything did; an import takes it for rows, not for a pointing zero. Rows without
/// any entry, the journal and first texts are not in it.
std::string readingsCsv(const Session& session);

}  // namespace alidade
