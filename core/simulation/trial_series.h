#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/simulation/blind_trial.h"
#include "core/simulation/trial_score.h"

namespace alidade {

/// A trial with its seal open.
struct ScoredTrial {
  SealedTruth truth;
  TrialScore score;
  /// Where it was asked for: with the truth's effect taken from the catalogue, was a wrong cause blamed?
  /// Absent for truths that are no effect, or that do not show.
  std::optional<bool> wrongWithout = {};
};

/// A session and its truth.
struct TrialCase {
  Session session;
  SealedTruth seal;
};

struct TrialSeriesOptions {
  std::size_t count = 100;
  bool withheld = false;  ///< check each effect with itself taken from the catalogue, too
  unsigned threads = 0;   ///< 0: as many as the machine has; the result does not depend on it
  /// Called with the number of trials done, from whichever thread did one; one call at a time.
  std::function<void(std::size_t)> progress = {};
};

/// Diagnoses and scores the trials that `trialAt` gives for 0…count − 1; it is called from several threads.
/// In their order. The first problem in that order, where there is one.
Result<std::vector<ScoredTrial>> scoreTrials(const TrialSeriesOptions& options,
                                             const std::function<Result<TrialCase>(std::size_t)>& trialAt);

/// Trials drawn one after the other; trial i of `seed` is `drawBlindTrial(draw, seed + i)`.
Result<std::vector<ScoredTrial>> scoreDrawnTrials(const TrialSeriesOptions& options,
                                                  const BlindTrialOptions& draw, std::uint64_t seed);

/// Trials made elsewhere: `folder`/truth.json and `folder`/sessions/ID.alidade for each id in it, or
/// `folder`/ID.alidade where there is no such folder; the count of the options does not matter. The sentence
/// of a problem names the file.
Result<std::vector<ScoredTrial>> scoreStoredTrials(const TrialSeriesOptions& options,
                                                   const std::string& folder);

}  // namespace alidade
