#pragma once

#include <optional>
#include <string_view>

#include "core/session/sighting_protocol.h"
#include "core/simulation/protocol.h"

namespace alidade {

/// What `simulate` would read by a plan, in the same order, as a protocol that a session can follow. The
/// zeros are sighted in face 1, and where both faces are read in face 2, too.
SightingProtocol templateOf(const Protocol& protocol);

/// By the name that `simulate --protocol` knows it by; absent where there is none.
std::optional<SightingProtocol> templateNamed(std::string_view name);

}  // namespace alidade
