#pragma once

#include <string>

#include "core/simulation/adaptive_trial.h"

namespace alidade::console {

/// Right answers, sightings and minutes of both orders, by kind of cause, as text.
std::string adaptiveTrialText(const AdaptiveTrials& trials);

/// One JSON document: every trial, and every watched session without an effect.
std::string adaptiveTrialJson(const AdaptiveTrials& trials);

/// Curves of both orders over sightings and over minutes, as CSV: the percentages of sessions named rightly
/// and wrongly, for each kind of cause and for all kinds, and the mean U of Δd (mm) of clean sessions.
std::string adaptiveTrialCsv(const AdaptiveTrials& trials);

}  // namespace alidade::console
