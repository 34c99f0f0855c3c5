#pragma once

#include <vector>

#include "core/session/session.h"
#include "ui/document/half_typed.h"

namespace alidade::ui {

class SessionDocument;

/// Commits unfinished entries in the same way as their widgets. Ignores texts at places the session lacks.
void handIn(SessionDocument& document, const std::vector<HalfTypedText>& texts);

/// The session after committing these texts.
Session withHandedIn(const Session& session, const std::vector<HalfTypedText>& texts);

}  // namespace alidade::ui
