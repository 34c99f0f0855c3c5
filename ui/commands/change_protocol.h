#pragma once

#include <optional>
#include <string>

#include "core/session/sighting_protocol.h"

namespace alidade::ui {

class SessionDocument;

/// Sets the session's protocol, which a person chose, and adds its missing positions, in one step; absent:
/// none. Does nothing if it is already set.
void followProtocol(SessionDocument& document, std::optional<SightingProtocol> protocol);

}  // namespace alidade::ui
