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
  /// Whether a diagnosis named a wrong cause after the truth's effect was removed from the catalogue. Absent
  /// if not requested, and for truths that are not effects or are undetectable.
  std::optional<bool> wrongWithout = {};
};

/// A session and its truth.
struct TrialCase {
  Session session;
  SealedTruth seal;
};

struct TrialSeriesOptions {
  std::size_t count = 100;
  bool withheld = false;            ///< also diagnose each session with its effect removed from the catalogue
  std::vector<OwnEffect> own = {};  ///< added to the stored sessions of their owner
  unsigned threads = 0;             ///< 0: as many as the machine has; the result is the same for any number
  /// Called with the number of finished trials, from any thread, one call at a time.
  std::function<void(std::size_t)> progress = {};
};

/// Diagnoses and scores the trials `trialAt(0)` … `trialAt(count − 1)`; several threads call `trialAt`.
/// Returns the scores in this order, or the first problem in this order.
Result<std::vector<ScoredTrial>> scoreTrials(const TrialSeriesOptions& options,
                                             const std::function<Result<TrialCase>(std::size_t)>& trialAt);

/// Trials drawn in sequence; trial i of `seed` is `drawBlindTrial(draw, seed + i)`.
Result<std::vector<ScoredTrial>> scoreDrawnTrials(const TrialSeriesOptions& options,
                                                  const BlindTrialOptions& draw, std::uint64_t seed);

/// Trials stored in `folder`: truth.json, and the session ID.alidade for each id in truth.json. Sessions are
/// in the subfolder `sessions`, or in `folder` itself if there is no subfolder. The count of the options is
/// ignored. Problems name the file.
Result<std::vector<ScoredTrial>> scoreStoredTrials(const TrialSeriesOptions& options,
                                                   const std::string& folder);

}  // namespace alidade
