#pragma once

#include <string>
#include <vector>

#include "core/guidance/outlook.h"
#include "core/guidance/sightings_to_repeat.h"
#include "core/session/protocol_progress.h"
#include "core/session/sighting_protocol.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// Sentences for a session that follows a protocol.

/// "pointing zero, face 2", "point 5, round 2, face 2".
std::string sightingName(const PlannedSighting& planned);
/// "0°: point 5, round 2, face 2".
std::string sightingNameInSession(const PlannedSighting& planned);

/// "to come", "next", "skipped", "taken" or "excluded".
std::string stateName(SightingState state);

/// "23 of 72 sightings are taken.", then the numbers of skipped, excluded, out-of-order and unplanned ones.
std::string progressSentences(const ProtocolProgress& progress);

/// "2 readings are not in the protocol."; empty if there are none.
std::string unplannedSentence(const ProtocolProgress& progress);

/// Which sightings to repeat, and why.
std::string repeatSentence(const SightingsToRepeat& toRepeat, const ProtocolProgress& progress);

/// States that misread sightings increase U until they are repeated; empty if none looks misread.
std::string repeatsFirst(const std::vector<SightingsToRepeat>& allToRepeat);

/// How U decreases with the rest of the protocol and with further rounds. States the U that a verdict needs,
/// if there is a tolerance, and whether the rounds suffice.
std::string outlookSentences(const Outlook& outlook, const ProtocolProgress& progress);

/// Describes the sightings of a protocol: "17 places, both faces, there and back, with slider readings".
std::string protocolInWords(const SightingProtocol& protocol);

/// States how far a session kept to its protocol, and names the sightings that deviate from it: "66 of 68
/// sightings are taken. Skipped: 0°: point 5; 0°: point 6. Taken again: 180°: point 2."
std::string deviationSentences(const ProtocolProgress& progress);

}  // namespace alidade
