#pragma once

#include <string>

#include "core/simulation/adaptive_trial.h"

namespace alidade::console {

/// Right answers, sightings and minutes of both orders, by kind of cause, as text.
std::string adaptiveTrialText(const AdaptiveTrials& trials);

/// One JSON document: every trial, and every watched session without an effect.
std::string adaptiveTrialJson(const AdaptiveTrials& trials);

/// Curves of both ways against sightings and against minutes, as CSV: of each kind and of all the shares of
/// sessions named rightly and wrongly by then, and the mean U of Δd (mm) of the clean sessions.
std::string adaptiveTrialCsv(const AdaptiveTrials& trials);

}  // namespace alidade::console
