#include "core/simulation/trial_summary.h"

#include <limits>

namespace alidade {

namespace {

/// The bins are finer where detection begins. 6 is `clearVisibility`, 25 the largest visibility drawn.
std::vector<DetectionBin> emptyBins() {
  constexpr double edges[] = {0, 2, 3, 4, 5, 6, 8, 10, 15, 25, std::numeric_limits<double>::infinity()};
  std::vector<DetectionBin> bins;
  for (std::size_t i = 0; i + 1 < std::size(edges); ++i)
    bins.push_back({.from = edges[i], .to = edges[i + 1], .detected = {}, .named = {}});
  return bins;
}

}  // namespace

TrialSummary summarise(const std::vector<ScoredTrial>& trials) {
  TrialSummary summary{.count = trials.size(), .detection = emptyBins()};
  for (const ScoredTrial& trial : trials) {
    const TrialScore& score = trial.score;
    summary.right[score.trialClass].add(score.right);
    ++summary.confusion[trial.truth.kind][score.answer];
    KindTally& kind = summary.kinds[trial.truth.kind];
    kind.right.add(score.right);
    kind.named.add(score.named);
    kind.quiet.add(!score.detected);
    if (score.coveredAfter) kind.after.add(*score.coveredAfter);
    if (score.coveredMeasured) kind.measured.add(*score.coveredMeasured);
    if (score.trialClass == TrialClass::None) summary.falseAlarms.add(score.detected);
    if (score.covered) summary.covered.add(*score.covered);
    if (score.backToNoise) summary.backToNoise.add(*score.backToNoise);
    if (trial.wrongWithout) summary.wrongWithout.add(*trial.wrongWithout);
    if (!trial.truth.visible) continue;
    for (DetectionBin& bin : summary.detection) {
      if (*trial.truth.visible < bin.from || *trial.truth.visible >= bin.to) continue;
      bin.detected.add(score.detected);
      bin.named.add(score.named);
    }
  }
  std::erase_if(summary.detection, [](const DetectionBin& bin) { return bin.detected.count == 0; });
  return summary;
}

}  // namespace alidade
