#pragma once

#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// All places of a protocol with all faces of its rounds. Its `rows`, for whose duration a drift is stated,
/// exclude the sightings that `openOrder` added.
SightingPlan openPlan(const SightingProtocol& protocol);

}  // namespace alidade
