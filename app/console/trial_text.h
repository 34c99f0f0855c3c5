#pragma once

#include <string>
#include <vector>

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

}  // namespace alidade::console
