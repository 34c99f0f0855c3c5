#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/adjustment/result/expected_reading.h"
#include "core/guidance/repeats.h"
#include "core/session/protocol_progress.h"

namespace alidade::ui {

struct Evaluation;

/// How far a session is in the protocol it follows.
struct Guide {
  SightingProtocol protocol;
  ProtocolProgress progress;
  std::vector<std::optional<ExpectedReading>> expected;  ///< of each sighting
  std::vector<Repeat> repeats;  ///< those that look misread once these are searched for
  std::string problem = {};     ///< why the session's protocol cannot be followed; then all else is empty
};

/// Of an evaluation that is fitted; null where its session follows none, or has more rows than anyone types.
std::shared_ptr<const Guide> guideOf(const Evaluation& evaluation);

}  // namespace alidade::ui
