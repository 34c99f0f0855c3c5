#pragma once

#include <string>
#include <vector>

#include "core/simulation/adaptive_trial.h"
#include "core/simulation/series_trial.h"
#include "core/simulation/trial_summary.h"

namespace alidade::console {

/// Scores of blind trials as text.
std::string trialText(const std::vector<ScoredTrial>& trials, const TrialSummary& summary);

/// One JSON document: the summary, and each trial with its truth, answer and score.
std::string trialJson(const std::vector<ScoredTrial>& trials, const TrialSummary& summary);

/// Scores of blind trials of series as text.
std::string seriesTrialText(const std::vector<ScoredSeries>& series);

/// One JSON document: the summary, and each series with its truth, answer and score.
std::string seriesTrialJson(const std::vector<ScoredSeries>& series);

/// Right answers, sightings and minutes of both orders, by kind of cause, as text.
std::string adaptiveTrialText(const AdaptiveTrials& trials);

/// One JSON document: each trial with a cause, in both orders; each session without a cause, in the order by
/// worth.
std::string adaptiveTrialJson(const AdaptiveTrials& trials);

/// Curves of both orders over sightings and over minutes, as CSV: the percentages of sessions named rightly
/// and wrongly, for each kind of cause and for all kinds, and the mean U of Δd (mm) of clean sessions.
std::string adaptiveTrialCsv(const AdaptiveTrials& trials);

}  // namespace alidade::console
