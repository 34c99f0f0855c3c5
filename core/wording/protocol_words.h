#pragma once

#include <string>

#include "core/session/protocol_progress.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// Describes the sightings of a protocol: "17 places, both faces, there and back, with slider readings".
std::string protocolInWords(const SightingProtocol& protocol);

/// States how far a session kept to its protocol, and names the sightings that deviate from it: "66 of 68
/// sightings are taken. Skipped: 0°: point 5; 0°: point 6. Taken again: 180°: point 2."
std::string deviationSentences(const ProtocolProgress& progress);

}  // namespace alidade
