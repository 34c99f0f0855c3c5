#pragma once

#include <string>
#include <vector>

#include "core/simulation/series_trial.h"

namespace alidade::console {

/// Scores of blind trials of series as text.
std::string seriesTrialText(const std::vector<ScoredSeries>& series);

/// One JSON document: the summary, and each series with its truth, answer and score.
std::string seriesTrialJson(const std::vector<ScoredSeries>& series);

}  // namespace alidade::console
