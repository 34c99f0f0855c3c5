#pragma once

#include <optional>
#include <string_view>

#include "core/session/sighting_protocol.h"
#include "core/simulation/protocol.h"

namespace alidade {

/// The readings of `simulate` for a plan, in the same order, as a protocol that a session can follow. The
/// zeros are sighted in face 1, and also in face 2 if both faces are read.
SightingProtocol templateOf(const Protocol& protocol);

/// The protocol of a new session. It applies only until a row of the session departs from it (`isYielding`).
/// It has the points of `paper` without slider coordinates, since these differ from device to device.
SightingProtocol usualProtocol();

/// Finds a template by its name in `simulate --protocol`; absent if the name is unknown.
std::optional<SightingProtocol> templateNamed(std::string_view name);

}  // namespace alidade
