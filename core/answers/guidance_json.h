#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/guidance/outlook.h"
#include "core/guidance/repeats.h"
#include "core/session/protocol_progress.h"

namespace alidade {

/// How far a session is in its protocol, and all that is said of it.
struct Guidance {
  SightingProtocol protocol;
  ProtocolProgress progress;
  std::vector<std::optional<ExpectedReading>> expected;  ///< of each sighting
  std::vector<Repeat> repeats;
  Outlook outlook;
};

/// One JSON document.
std::string guidanceJson(const std::string& session, const Guidance& guidance);

}  // namespace alidade
