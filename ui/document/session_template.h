#pragma once

#include "core/session/session.h"

namespace alidade::ui {

/// The content of a new session: the template stored on this machine, else blank with the usual protocol.
Session templateSession();
/// Stores `session` as the template of new sessions.
void keepTemplate(const Session& session);

}  // namespace alidade::ui
