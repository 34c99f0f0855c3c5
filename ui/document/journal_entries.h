#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/place.h"
#include "core/session/journal.h"
#include "core/session/session.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

/// The number by which `Stands` is asked for a row that is added.
inline constexpr std::size_t asAdded = std::numeric_limits<std::size_t>::max();

/// Does the entry stand, so that its change is one of the journal?
using Stands = std::function<bool(std::size_t row, ReadingColumn column)>;

/// The entries that tell of a patch of the rows of one position, in the order of its cells and rows, without
/// time, operator and hash. Of an edit of more than a thousand cells or rows it is one that counts them: each
/// changed row keeps its first texts itself.
std::vector<JournalEntry> entriesOf(const Session& session, std::size_t position, const ReadingsPatch& patch,
                                    const char* why, const Stands& stands);

/// Likewise of the text of a field, or of anything else that has a name in the session file.
JournalEntry entryOf(const Session& session, const Place& field, std::string from, std::string to);

/// The reverse changes, the last first.
std::vector<JournalEntry> reversed(const std::vector<JournalEntry>& entries);

/// Is what stands in this field part of the measurement, and not only said about it?
bool isOfMeasurement(const Place& field);

}  // namespace alidade::ui
