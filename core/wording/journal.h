#pragma once

#include <string>

#include "core/session/session.h"

namespace alidade {

/// "2026-03-14 15:09", in UTC; as written where it is no time.
std::string timeText(const std::string& at);

/// "suggestion accepted"; as written where it is no reason that this program knows.
std::string reasonText(const JournalEntry& entry);

/// How many cells of readings are not as they were first entered, whether the journal is whole, and how the
/// session was sealed: up to three sentences. Texts of the session are not made visible.
std::string journalSummary(const Session& session);

}  // namespace alidade
