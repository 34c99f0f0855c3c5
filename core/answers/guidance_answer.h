#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/guidance/outlook.h"
#include "core/guidance/sighting_choice.h"
#include "core/guidance/sightings_to_repeat.h"
#include "core/session/protocol_progress.h"
#include "core/session/session.h"

namespace alidade {

/// The progress of a session in its protocol, with the findings on it.
struct Guidance {
  SightingProtocol protocol;
  ProtocolProgress progress;
  std::vector<std::optional<ExpectedReading>> expected;  ///< for each sighting
  std::optional<SightingChoice> choice = {};             ///< in a protocol by worth
  std::optional<SightingsAhead> ahead = {};              ///< in a protocol by worth: to reach `uncertainty`
  std::optional<double> uncertainty = {};                ///< U of Δd, mm
  std::vector<SightingsToRepeat> allToRepeat;
  Outlook outlook;
};

/// Fits and diagnoses the session. Returns the progress alone if the session contains nothing that can be
/// fitted. `uncertainty`: the intended U of Δd, mm, in a protocol by worth.
Guidance guidanceOf(const Session& session, SightingProtocol protocol,
                    std::optional<double> uncertainty = {});

/// Returns one JSON document.
std::string guidanceJson(const std::string& session, const Guidance& guidance);

}  // namespace alidade
