#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/guidance/sighting_choice.h"
#include "core/guidance/sightings_to_repeat.h"
#include "core/session/protocol_progress.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

struct Evaluation;

/// The progress of a session in its protocol.
struct Guide {
  SightingProtocol protocol;
  ProtocolProgress progress;
  std::vector<std::optional<ExpectedReading>> expected;  ///< for each sighting
  std::optional<SightingChoice> choice = {};             ///< in a protocol by worth
  std::vector<SightingsToRepeat> allToRepeat;            ///< includes misread sightings only after the search
  std::string problem = {};  ///< why the protocol cannot be followed; everything else is then empty
};

/// The guide along a protocol. `fitted` is null if nothing of the session can be fitted; the guide is then
/// the progress alone.
Guide guideAlong(SightingProtocol protocol, const Session& session, const FittedSession* fitted);

/// The guide of a fitted evaluation; null without a protocol, or with more than `mostSightings` rows.
std::shared_ptr<const Guide> guideOf(const Evaluation& evaluation);

}  // namespace alidade
