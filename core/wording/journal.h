#pragma once

#include <string>

#include "core/session/journal_check.h"
#include "core/session/session.h"

namespace alidade {

/// "2026-03-14 15:09", in UTC; as written where it is no time.
std::string timeText(const std::string& at);

/// "suggestion accepted"; as written where it is no reason that this program knows.
std::string reasonText(const JournalEntry& entry);

/// What the journal or a seal says of a place and what the file holds, as a sentence.
std::string contradictionText(const JournalContradiction& one);

/// How many cells of readings are not as they were first entered, whether the journal holds and what speaks
/// against it, and how the session was sealed. Empty where there is nothing to say. Texts of the session are
/// not made visible.
std::string journalSummary(const Session& session);
std::string journalSummary(const Session& session, const JournalCheck& check);

}  // namespace alidade
