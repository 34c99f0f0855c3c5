#pragma once

#include <QString>
#include <cstddef>

#include "core/session/journal.h"
#include "core/session/row_fields.h"
#include "core/session/session.h"

namespace alidade::ui {

/// The place of the entry, named as when the entry was made: "0°, row 5 (point 5), vertical reading".
QString journalPlace(const JournalEntry& entry);

/// Reason, operator and time of the entry: "suggestion accepted, J. Doe, 2026-03-14 15:09 UTC".
QString changeText(const JournalEntry& entry, const Session& session);

/// The newest journal entry that gave this cell its present text; null if there is none.
const JournalEntry* lastChange(const Session& session, std::size_t position, std::size_t row,
                               const RowField& field);

}  // namespace alidade::ui
