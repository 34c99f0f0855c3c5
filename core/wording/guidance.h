#pragma once

#include <string>
#include <vector>

#include "core/guidance/outlook.h"
#include "core/guidance/repeats.h"
#include "core/session/protocol_progress.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// Sentences for a session that follows a protocol.

/// "pointing zero, face 2", "point 5, round 2, face 2".
std::string sightingName(const PlannedSighting& planned);
/// "0°: point 5, round 2, face 2".
std::string sightingNameInSession(const PlannedSighting& planned);

/// "to come", "next", "passed over", "taken", "excluded".
std::string stateName(SightingState state);

/// "23 of 72 sightings are there.", and sightings out of order.
std::string progressSentences(const ProtocolProgress& progress);

/// "2 readings are none of the protocol."; empty without any.
std::string unplannedSentence(const ProtocolProgress& progress);

/// Which sightings to repeat, and why.
std::string repeatSentence(const Repeat& repeat, const ProtocolProgress& progress);

/// States that misread sightings increase U until they are repeated; empty if none looks misread.
std::string repeatsFirst(const std::vector<Repeat>& repeats);

/// "Two more rounds bring U from 0.06 to 0.04 mm; the verdict needs 0.05 mm.", or what applies instead.
std::string outlookSentences(const Outlook& outlook, const ProtocolProgress& progress);

}  // namespace alidade
