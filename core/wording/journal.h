#pragma once

#include <string>
#include <vector>

#include "core/session/journal_check.h"
#include "core/session/session.h"

namespace alidade {

/// "2026-03-14 15:09", in UTC; unchanged if the text is not a time.
std::string timeText(const std::string& at);

/// "suggestion accepted"; unchanged if the reason is unknown to this program. For an exclusion, the note of
/// the row in the session is added: "excluded: tripod touched". For any other entry of the session's journal,
/// a reason stated later is added: "retyped: digits exchanged".
std::string reasonText(const JournalEntry& entry, const Session& session);

/// `text`, the entry's `from` or `to`, with the names of effects in place of their identifiers:
/// "trunnion tilt: 12 ± 2 arcsec", "collimation, trunnion tilt". Texts not about effects are unchanged.
std::string contentText(const JournalEntry& entry, const std::string& text);

/// Who sealed the session last, when, and how many changes are recorded since; does not check the content.
/// Empty if the session was never sealed.
std::string sealState(const std::vector<JournalEntry>& journal);

/// The contradiction between the journal or a seal and the file, as a sentence.
std::string contradictionText(const JournalContradiction& one);

/// States the number of changed reading cells, whether the journal is complete, contradictions, and how the
/// session was sealed. Empty if there is nothing to report. Texts of the session are returned without
/// escaping invisible characters.
std::string journalSummary(const Session& session);
std::string journalSummary(const Session& session, const JournalCheck& check);

}  // namespace alidade
