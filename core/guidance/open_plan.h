#pragma once

#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The plan of all places of a protocol with all faces of its rounds. `SightingPlan::rows`, to whose duration
/// a stated drift refers, excludes the sightings that `openOrder` added.
SightingPlan openPlan(const SightingProtocol& protocol);

}  // namespace alidade
