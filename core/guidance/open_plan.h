#pragma once

#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/protocol_progress.h"

namespace alidade {

/// The places of a protocol by worth with every face of its rounds. Drifts are stated for its rows without
/// the repeats of positions.
SightingPlan openPlan(const SightingProtocol& protocol, const ProtocolProgress& progress);

}  // namespace alidade
