#pragma once

#include <string>
#include <vector>

#include "core/session/journal_check.h"
#include "core/session/session.h"

namespace alidade {

/// "2026-03-14 15:09", in UTC; unchanged if the text is not a time.
std::string timeText(const std::string& at);

/// "suggestion accepted"; unchanged if the reason is unknown to this program. An exclusion has the note of
/// its row in the session: "excluded: tripod touched". Another entry of the session's journal has the reason
/// that was stated afterwards: "retyped: digits exchanged".
std::string reasonText(const JournalEntry& entry, const Session& session);

/// `text`, the entry's `from` or `to`, with the names of effects in place of their identifiers:
/// "trunnion tilt: 12 ± 2 arcsec", "collimation, trunnion tilt". Texts of other entries are unchanged.
std::string contentText(const JournalEntry& entry, const std::string& text);

/// "Sealed 2026-03-14 15:09 UTC by R. Roe", or that it was changed since, without a check of the content;
/// empty if the session was never sealed.
std::string sealState(const std::vector<JournalEntry>& journal);

/// The contradiction between the journal or a seal and the file, as a sentence.
std::string contradictionText(const JournalContradiction& one);

/// States the number of changed reading cells, whether the journal is complete, contradictions, and how the
/// session was sealed. Empty if there is nothing to report. Texts of the session are returned without
/// escaping invisible characters.
std::string journalSummary(const Session& session);
std::string journalSummary(const Session& session, const JournalCheck& check);

}  // namespace alidade
