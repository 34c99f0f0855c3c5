#pragma once

#include "core/session/session.h"

namespace alidade::ui {

/// The content of a new session: as kept on this machine, else blank with the usual protocol.
Session templateSession();
/// Keeps the entries of `session` for new sessions.
void keepTemplate(const Session& session);

}  // namespace alidade::ui
