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

/// The row number passed to `IsRecorded` for an added row.
inline constexpr std::size_t asAdded = std::numeric_limits<std::size_t>::max();

/// True if the entry is recorded, so that its change enters the journal.
using IsRecorded = std::function<bool(std::size_t row, ReadingColumn column)>;

/// The journal entries for a patch of the rows of one position, in the order of cells and rows, without time,
/// operator and hash. An edit of more than a thousand cells or rows gets one entry with the count: each
/// changed row keeps its first texts itself.
std::vector<JournalEntry> entriesOf(const Session& session, std::size_t position, const ReadingsPatch& patch,
                                    const char* why, const IsRecorded& isRecorded);

/// Returns the entry for the text of a field, or of anything else named in the session file.
JournalEntry entryOf(const Session& session, const Place& field, std::string from, std::string to);

/// The reverse changes, the last first.
std::vector<JournalEntry> reversed(const std::vector<JournalEntry>& entries);

/// True if the field is part of the measurement rather than a remark about it.
bool isOfMeasurement(const Place& field);

}  // namespace alidade::ui
