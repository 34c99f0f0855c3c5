#pragma once

#include <optional>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/guidance/outlook.h"
#include "core/guidance/repeats.h"
#include "core/session/protocol_progress.h"
#include "core/session/session.h"

namespace alidade {

/// How far a session is in its protocol, and all that is said of it.
struct Guidance {
  SightingProtocol protocol;
  ProtocolProgress progress;
  std::vector<std::optional<ExpectedReading>> expected;  ///< of each sighting
  std::vector<Repeat> repeats;
  Outlook outlook;
};

/// Fits and diagnoses the session. Where it holds nothing that can be fitted, progress alone is told.
Guidance guidanceOf(const Session& session, SightingProtocol protocol);

}  // namespace alidade
