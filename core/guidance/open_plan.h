#pragma once

#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The places of a protocol with every face of its rounds. Drifts are stated for its rows without what
/// `openOrder` added.
SightingPlan openPlan(const SightingProtocol& protocol);

}  // namespace alidade
