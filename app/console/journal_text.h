#pragma once

#include <string>

#include "core/session/journal_check.h"
#include "core/session/session.h"

namespace alidade::console {

/// Recorded changes in order; below them whether the journal is complete and how the session was sealed.
std::string journalText(const std::string& name, const Session& session, const JournalCheck& check);

/// {"session", "whole", "changed_readings", "contradictions": […], "sealed": null or {"at", "by", "revision",
/// "unchanged"}, "seals": […], "entries": [as in the session file]}.
std::string journalJson(const std::string& name, const Session& session, const JournalCheck& check,
                        const std::string& digest = {});

}  // namespace alidade::console
