#include "core/simulation/trial_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace alidade {
namespace {

using testing::ElementsAre;

/// Scored trials of any kind, with drawn answers, hits and visibilities.
std::vector<ScoredTrial> drawnTrials(std::size_t count) {
  std::mt19937_64 random(count);
  const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  const auto drawnFlag = [&]() -> std::optional<bool> {
    const int drawn = below(3);
    return drawn == 2 ? std::nullopt : std::optional(drawn == 1);
  };
  std::vector<ScoredTrial> trials(count);
  for (ScoredTrial& trial : trials) {
    trial.truth.kind =
        std::vector<std::string>{"none", "plane_warp", "gross_error"}[static_cast<std::size_t>(below(3))];
    if (below(4) > 0) trial.truth.visible = std::uniform_real_distribution<double>(0, 40)(random);
    trial.score.trialClass = static_cast<TrialClass>(below(8));
    trial.score.answer = below(2) == 0 ? "within-noise" : "plane_warp";
    trial.score.right = below(2) == 0;
    trial.score.detected = below(3) > 0;
    trial.score.named = trial.score.detected && below(2) == 0;
    trial.score.covered = drawnFlag();
    trial.score.backToNoise = drawnFlag();
    trial.wrongWithout = drawnFlag();
  }
  return trials;
}

/// The number of trials satisfying `among` that are counted, and the number of hits.
Tally counted(const std::vector<ScoredTrial>& trials, const std::function<bool(const ScoredTrial&)>& among,
              const std::function<bool(const ScoredTrial&)>& isHit) {
  Tally tally;
  for (const ScoredTrial& trial : trials)
    if (among(trial)) tally += {.hits = isHit(trial) ? 1u : 0u, .count = 1};
  return tally;
}

ScoredTrial showing(double visible) {
  ScoredTrial trial;
  trial.truth.visible = visible;
  trial.score.detected = true;
  return trial;
}

TEST(TrialSummary, CountsWhatWasDrawn) {
  using Trial = const ScoredTrial&;
  const std::vector<ScoredTrial> trials = drawnTrials(500);
  const TrialSummary summary = summarise(trials);
  EXPECT_EQ(summary.count, 500u);
  ASSERT_EQ(summary.right.size(), 8u);
  for (const auto& [trialClass, tally] : summary.right)
    EXPECT_EQ(tally,
              counted(
                  trials, [&, &trialClass = trialClass](Trial t) { return t.score.trialClass == trialClass; },
                  [](Trial t) { return t.score.right; }))
        << nameOf(trialClass);
  EXPECT_EQ(summary.falseAlarms, counted(
                                     trials, [](Trial t) { return t.score.trialClass == TrialClass::None; },
                                     [](Trial t) { return t.score.detected; }));
  EXPECT_EQ(summary.covered, counted(
                                 trials, [](Trial t) { return t.score.covered.has_value(); },
                                 [](Trial t) { return *t.score.covered; }));
  EXPECT_EQ(summary.backToNoise, counted(
                                     trials, [](Trial t) { return t.score.backToNoise.has_value(); },
                                     [](Trial t) { return *t.score.backToNoise; }));
  EXPECT_EQ(summary.wrongWithout, counted(
                                      trials, [](Trial t) { return t.wrongWithout.has_value(); },
                                      [](Trial t) { return *t.wrongWithout; }));
  std::size_t answered = 0;
  for (const auto& [kind, answers] : summary.confusion)
    for (const auto& [answer, times] : answers) {
      const Tally expected = counted(
          trials, [&, &kind = kind](Trial t) { return t.truth.kind == kind; },
          [&, &answer = answer](Trial t) { return t.score.answer == answer; });
      EXPECT_EQ(times, expected.hits) << kind << " taken for " << answer;
      answered += times;
    }
  EXPECT_EQ(answered, trials.size());
  for (const DetectionBin& bin : summary.detection) {
    const auto isIn = [&](Trial t) {
      return t.truth.visible && *t.truth.visible >= bin.from && *t.truth.visible < bin.to;
    };
    EXPECT_EQ(bin.detected, counted(trials, isIn, [](Trial t) { return t.score.detected; })) << bin.from;
    EXPECT_EQ(bin.named, counted(trials, isIn, [](Trial t) { return t.score.named; })) << bin.from;
  }
}

// Bins are adjacent, and every effect with a known trace is in one of them.
TEST(TrialSummary, PutsEachEffectIntoOneBin) {
  const std::vector<ScoredTrial> trials = drawnTrials(300);
  const std::vector<DetectionBin> bins = summarise(trials).detection;
  Tally all;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    all += bins[i].detected;
    EXPECT_LT(bins[i].from, bins[i].to);
    EXPECT_GE(bins[i].from, i > 0 ? bins[i - 1].to : 0);
  }
  EXPECT_EQ(all, counted(
                     trials, [](const ScoredTrial& t) { return t.truth.visible.has_value(); },
                     [](const ScoredTrial& t) { return t.score.detected; }));
}

// Effects visible by 6 σ are in the required range; slightly less is not. Bins without effects are not
// listed.
TEST(TrialSummary, BeginsABinAtItsEdge) {
  const std::vector<DetectionBin> bins =
      summarise({showing(0), showing(5.999), showing(6), showing(1e6)}).detection;
  std::vector<double> begins;
  for (const DetectionBin& bin : bins) {
    begins.push_back(bin.from);
    EXPECT_EQ(bin.detected, (Tally{1, 1}));
    EXPECT_EQ(bin.named, (Tally{0, 1}));
  }
  EXPECT_THAT(begins, ElementsAre(0, 5, clearVisibility, 25));
}

TEST(TrialSummary, DoesNotHangOnTheOrder) {
  std::vector<ScoredTrial> trials = drawnTrials(60);
  const TrialSummary before = summarise(trials);
  std::ranges::reverse(trials);
  const TrialSummary after = summarise(trials);
  EXPECT_EQ(before.right, after.right);
  EXPECT_EQ(before.confusion, after.confusion);
  EXPECT_EQ(before.covered, after.covered);
}

TEST(TrialSummary, OfNoTrialsIsEmpty) {
  const TrialSummary summary = summarise({});
  EXPECT_EQ(summary.count, 0u);
  EXPECT_TRUE(summary.right.empty());
  EXPECT_TRUE(summary.confusion.empty());
  EXPECT_TRUE(summary.detection.empty());
  EXPECT_EQ(summary.falseAlarms, Tally());
}

}  // namespace
}  // namespace alidade
