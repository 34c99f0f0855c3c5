#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/session/session.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The rows and pointing zeros of a session as a protocol, to repeat it or as a template. Places are those of
/// each position's rows, with their slider readings if any. Positions without rows are sighted like the first
/// position with rows. The result has no positions without rows, or with too many for a protocol
/// (`mostSightings`).
SightingProtocol protocolFromRows(const Session& session);

/// Whether a protocol can request this measure. False for a second stand-off and for measured distances.
bool isForProtocol(Measure measure);

/// The protocol with the measures of an advice added, except those that a protocol cannot request. The result
/// has no positions if it would exceed a protocol's limit.
SightingProtocol withMeasures(SightingProtocol protocol, const std::vector<Measure>& measures);

}  // namespace alidade
