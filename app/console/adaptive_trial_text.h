#pragma once

#include <string>

#include "core/simulation/adaptive_trial.h"

namespace alidade::console {

/// Right answers, sightings and minutes of both orders, by kind of cause, as text.
std::string adaptiveTrialText(const AdaptiveTrials& trials);

/// One JSON document: every trial, and the clean sessions watched.
std::string adaptiveTrialJson(const AdaptiveTrials& trials);

}  // namespace alidade::console
