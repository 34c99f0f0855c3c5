#pragma once

#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/session/session.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// What a session's rows and pointing zeros are, as a protocol: so it can be taken again, or be a template.
/// Places are those of each position's first round, with their slider readings where there are any.
/// Positions without rows are sighted as the first that has some. Without positions where no row is there,
/// or where it would be more than a protocol holds (`mostSightings`).
SightingProtocol protocolFromRows(const Session& session);

/// Can a protocol ask for it? Not for another stand-off, nor for a distance.
bool isForProtocol(Measure measure);

/// A protocol with what an advice measures besides; what a protocol cannot ask for is left to the reader.
/// Without positions where it would be more than a protocol holds.
SightingProtocol withMeasures(SightingProtocol protocol, const std::vector<Measure>& measures);

}  // namespace alidade
