#pragma once

#include <string>

#include "core/guidance/sighting_choice.h"
#include "core/session/protocol_progress.h"
#include "core/statement/statement.h"

namespace alidade {

/// Why the chosen sighting is next, which others tell nearly as much, and whether the readings are enough.
/// Also the possible causes with their probabilities, and the effects that were not looked for.
Statement sightingChoiceStatement(const SightingChoice& choice, const ProtocolProgress& progress);

/// "Enough: the cause is named, the collimation (98 %). …"; also if it is not enough yet.
std::string enoughSentence(const SessionSoFar& state);

}  // namespace alidade
