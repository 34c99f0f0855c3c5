#pragma once

#include <string>
#include <vector>

#include "core/simulation/trial_summary.h"

namespace alidade::console {

/// Scores of blind trials as text.
std::string trialText(const std::vector<ScoredTrial>& trials, const TrialSummary& summary);

/// One JSON document: the summary, and each trial with its truth, answer and score.
std::string trialJson(const std::vector<ScoredTrial>& trials, const TrialSummary& summary);

}  // namespace alidade::console
