#pragma once

#include <string>

#include "core/session/protocol_progress.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

/// A protocol by what is sighted: "17 places, both faces, there and back, with slider readings".
std::string protocolInWords(const SightingProtocol& protocol);

/// How far a session kept to its protocol, with the sightings concerned by name: "66 of 68 sightings are
/// there. Passed over: 0°: point 5; 0°: point 6. Taken again: 180°: point 2.".
std::string deviationSentences(const ProtocolProgress& progress);

}  // namespace alidade
