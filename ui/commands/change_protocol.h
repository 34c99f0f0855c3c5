#pragma once

#include <optional>
#include <string>

#include "core/session/sighting_protocol.h"

namespace alidade::ui {

class SessionDocument;

/// Sets the protocol that the user chose and adds the positions that it needs, as one undo step. If
/// `protocol` is absent, removes the protocol. Does nothing if the session already has this protocol.
void followProtocol(SessionDocument& document, std::optional<SightingProtocol> protocol);

}  // namespace alidade::ui
