#pragma once

#include <string>

#include "core/diagnosis/sightings_ahead.h"
#include "core/guidance/sighting_choice.h"
#include "core/session/protocol_progress.h"
#include "core/statement/statement.h"

namespace alidade {

/// States why the chosen sighting is next, which others are nearly as informative, and whether the readings
/// are enough. Lists the possible causes with their probabilities, and the effects not looked for.
Statement sightingChoiceStatement(const SightingChoice& choice, const ProtocolProgress& progress);

/// "Enough: the cause is named, collimation (98 %); …", or why the readings are not enough yet.
std::string enoughSentence(const SessionSoFar& state);

/// "For U = 0.1 mm of Δd, whatever effect is there: 22 more sightings in 31 min.", with a row of points for
/// each position in turn. If U (`uncertainty`, mm) is not reached: the U reached, and what reduces U further.
Statement sightingsAheadStatement(const SightingsAhead& ahead, double uncertainty);

}  // namespace alidade
