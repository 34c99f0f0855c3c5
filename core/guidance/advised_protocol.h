#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/session/session.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// The rows and pointing zeros of a session as a protocol, to repeat it or as a template. Places are those of
/// each position's first round, with their slider readings if any. Positions without rows are sighted like
/// the first position with rows. Without positions if there are no rows, or too many for a protocol
/// (`mostSightings`).
SightingProtocol protocolFromRows(const Session& session);

/// Can a protocol request this measure? False for changing and for measuring the distance of the instrument.
bool isForProtocol(Measure measure);

/// A protocol with the additional measurements of an advice, except measures that a protocol cannot request.
/// Without positions if it would exceed a protocol's limit.
SightingProtocol withMeasures(SightingProtocol protocol, const std::vector<Measure>& measures);

}  // namespace alidade
