#pragma once

#include <optional>
#include <string>

#include "core/session/sighting_protocol.h"

namespace alidade::ui {

class SessionDocument;

/// Sets the session's protocol, absent: none, and adds its missing positions, in one step. Does nothing if it
/// is already set.
void followProtocol(SessionDocument& document, const std::optional<SightingProtocol>& protocol);

}  // namespace alidade::ui
