#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/problem.h"
#include "core/session/journal.h"
#include "core/session/session.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

/// The row number passed to `IsRecorded` for an added row.
inline constexpr std::size_t asAdded = std::numeric_limits<std::size_t>::max();

/// True if the cell's text is recorded, so that a change of the text enters the journal.
using IsRecorded = std::function<bool(std::size_t row, ReadingColumn column)>;

/// The journal entries for a patch of one position's rows: first cells, then removed rows, then added rows.
/// Time, operator and hash are empty. More than a thousand entries are replaced by one entry with
/// their number, since each changed row keeps its first texts itself.
std::vector<JournalEntry> entriesOf(const Session& session, std::size_t position, const ReadingsPatch& patch,
                                    const char* why, const IsRecorded& isRecorded);

/// The journal entry for a change from `from` to `to` at `field`, which is any place in the session file.
JournalEntry entryOf(const Session& session, const Place& field, std::string from, std::string to);

/// The reverse of each entry, the last entry first, without time and hash.
std::vector<JournalEntry> reversed(const std::vector<JournalEntry>& entries);

/// True if the field is part of the measurement rather than a remark about it.
bool isOfMeasurement(const Place& field);

}  // namespace alidade::ui
