#pragma once

#include <string>

#include "core/guidance/sighting_choice.h"
#include "core/session/protocol_progress.h"
#include "core/statement/statement.h"

namespace alidade {

/// Why this sighting is next and which tell nearly as much, whether those taken are enough, what may be the
/// case with its probability, and what was not looked for.
Statement sightingChoiceStatement(const SightingChoice& choice, const ProtocolProgress& progress);

/// "Enough: the cause is named, the collimation (98 %). …"; also if it is not enough yet.
std::string enoughSentence(const SessionSoFar& state);

}  // namespace alidade
