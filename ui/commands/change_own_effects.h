#pragma once

#include <vector>

#include "core/session/own_effect.h"

namespace alidade::ui {

class SessionDocument;

/// Puts an effect of one's own into the session, in the place of one with the same id.
void keepOwnEffect(SessionDocument& document, const OwnEffect& effect);

}  // namespace alidade::ui
