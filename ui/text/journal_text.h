#pragma once

#include <QString>
#include <cstddef>

#include "core/session/journal.h"
#include "core/session/row_fields.h"
#include "core/session/session.h"

namespace alidade::ui {

/// What the journal tells of, as it was called then: "0°, row 5 (point 5), vertical reading".
QString journalPlace(const JournalEntry& entry);

/// "suggestion accepted, J. Doe, 2026-03-14 15:09 UTC".
QString changeText(const JournalEntry& entry);

/// The newest entry of this cell, as it stands now; null where none tells of it.
const JournalEntry* lastChange(const Session& session, std::size_t position, std::size_t row,
                               const RowField& field);

}  // namespace alidade::ui
