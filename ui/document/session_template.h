#pragma once

#include "core/session/session.h"

namespace alidade::ui {

/// The session that a new one starts with: a blank one with the entries kept on this machine.
Session templateSession();
/// Keeps the entries of `session` for new sessions.
void keepTemplate(const Session& session);

}  // namespace alidade::ui
