#pragma once

#include <string>
#include <vector>

#include "core/guidance/outlook.h"
#include "core/guidance/repeats.h"
#include "core/session/protocol_progress.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// What a session that follows a protocol is told.

/// "pointing zero, face 2", "point 5, round 2, face 2".
std::string sightingName(const PlannedSighting& planned);
/// "0°: point 5, round 2, face 2".
std::string sightingNameInSession(const PlannedSighting& planned);

/// "to come", "next", "passed over", "taken", "excluded".
std::string stateName(SightingState state);

/// "23 of 72 sightings are there." and what is out of the order.
std::string progressSentences(const ProtocolProgress& progress);

/// What to take again, and why.
std::string repeatSentence(const Repeat& repeat, const ProtocolProgress& progress);

/// That U is smaller once they are taken again, where anything of it looks misread; empty where nothing does.
std::string repeatsFirst(const std::vector<Repeat>& repeats);

/// "Two more rounds bring U from 0.06 to 0.04 mm; the verdict needs 0.05 mm." or what there is to be said
/// instead. Effects are called as `name` has it.
std::string outlookSentences(const Outlook& outlook, const ProtocolProgress& progress,
                             const CauseNamer& name = byId);

}  // namespace alidade
