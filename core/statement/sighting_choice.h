#pragma once

#include <string>

#include "core/guidance/sighting_choice.h"
#include "core/session/protocol_progress.h"
#include "core/statement/statement.h"

namespace alidade {

/// States why the chosen sighting is next, which others are nearly as informative, and whether the readings
/// are enough. Lists the possible causes with their probabilities, and the effects not looked for.
Statement sightingChoiceStatement(const SightingChoice& choice, const ProtocolProgress& progress);

/// "Enough: the cause is named, collimation (98 %); …", or why the readings are not enough yet.
std::string enoughSentence(const SessionSoFar& state);

}  // namespace alidade
