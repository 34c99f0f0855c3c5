#pragma once

#include <vector>

#include "core/session/session.h"
#include "ui/document/half_typed.h"

namespace alidade::ui {

class SessionDocument;

/// Hands in what was half typed, each text as its entry would have. A text whose entry the session does not
/// have is passed over.
void handIn(SessionDocument& document, const std::vector<HalfTypedText>& texts);

/// The session as it would be then.
Session withHandedIn(const Session& session, const std::vector<HalfTypedText>& texts);

}  // namespace alidade::ui
