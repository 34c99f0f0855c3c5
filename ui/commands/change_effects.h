#pragma once

#include <string>
#include <vector>

#include "core/session/own_effect.h"

namespace alidade::ui {

class SessionDocument;

/// Adds the effect `id` to the estimated effects, or removes it; does nothing if the model agrees already.
/// Keeps all other effects, including unknown ones.
void setEffect(SessionDocument& document, const std::string& id, bool isEstimated);

/// Adds the effects of `ids` that are not estimated yet, as one undo step.
void addEffects(SessionDocument& document, const std::vector<std::string>& ids);

/// Puts a user's own effect into the session, replacing one with the same id.
void keepOwnEffect(SessionDocument& document, const OwnEffect& effect);

}  // namespace alidade::ui
