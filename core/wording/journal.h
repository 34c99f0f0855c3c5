#pragma once

#include <string>

#include "core/session/journal_check.h"
#include "core/session/session.h"

namespace alidade {

/// "2026-03-14 15:09", in UTC; unchanged if the text is not a time.
std::string timeText(const std::string& at);

/// "suggestion accepted"; unchanged if the reason is unknown to this program. An exclusion has the note of
/// its row in the session: "excluded: tripod touched".
std::string reasonText(const JournalEntry& entry, const Session& session);

/// The contradiction between the journal or a seal and the file, as a sentence.
std::string contradictionText(const JournalContradiction& one);

/// States the number of changed reading cells, whether the journal is complete, contradictions, and how the
/// session was sealed. Empty if there is nothing to report. Texts of the session are returned without
/// escaping invisible characters.
std::string journalSummary(const Session& session);
std::string journalSummary(const Session& session, const JournalCheck& check);

}  // namespace alidade
