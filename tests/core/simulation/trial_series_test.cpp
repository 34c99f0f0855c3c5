#include "core/simulation/trial_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "core/simulation/trial_summary.h"

namespace alidade {
namespace {

using testing::HasSubstr;

const std::string stored = ALIDADE_REFERENCE_DIR "/trials";

std::string fingerprint(const std::vector<ScoredTrial>& trials) {
  std::string text;
  for (const ScoredTrial& trial : trials)
    text += trial.truth.id + " " + trial.truth.kind + " " + trial.score.answer +
            (trial.score.right ? " right" : " wrong") +
            (trial.score.covered.value_or(false) ? " in\n" : "\n");
  return text;
}

TEST(TrialSeries, DoesNotDependOnTheNumberOfThreads) {
  const auto one = scoreDrawnTrials({.count = 6, .threads = 1}, {.protocol = "paper"}, 50);
  const auto three = scoreDrawnTrials({.count = 6, .threads = 3}, {.protocol = "paper"}, 50);
  ASSERT_EQ(one->size(), 6u);
  EXPECT_EQ(fingerprint(*one), fingerprint(*three));
  EXPECT_EQ((*one)[3].truth.kind, drawBlindTrial({.protocol = "paper"}, 53)->seal.kind);
}

TEST(TrialSeries, ReportsEveryTrialOnce) {
  std::atomic<std::size_t> calls = 0, last = 0;
  const auto trials = scoreDrawnTrials({.count = 6,
                                        .threads = 2,
                                        .progress =
                                            [&](std::size_t done) {
                                              ++calls;
                                              last = done;
                                            }},
                                       {.protocol = "paper", .kinds = {"none"}}, 1);
  EXPECT_EQ(trials->size(), 6u);
  EXPECT_EQ(calls, 6u);
  EXPECT_EQ(last, 6u);
}

// The ray tracer's stored sessions; one of the two-cause sessions has a cause that is undetectable.
TEST(TrialSeries, ScoresTrialsMadeElsewhere) {
  const auto trials = scoreStoredTrials({}, stored);
  ASSERT_TRUE(trials) << trials.problem().text();
  ASSERT_EQ(trials->size(), 35u);
  for (const ScoredTrial& trial : *trials)
    EXPECT_TRUE(trial.score.right || trial.truth.kind == "two_causes")
        << trial.truth.id << " " << trial.truth.kind << " taken for " << trial.score.answer;
  const TrialSummary summary = summarise(*trials);
  EXPECT_EQ(summary.falseAlarms.hits, 0u);
  EXPECT_EQ(summary.backToNoise.hits, summary.backToNoise.count);
}

// With one face and without slider only evenly spaced places show which circle was misread: in 84 of 100
// drawn sessions; otherwise the choice is random. Uncatalogued disturbances stay unexplained if no effect
// resembles them: with one face and one sweep, in 6 of the 10 drawn here.
TEST(TrialSeries, IsRightWhereOnlyTheSurroundingsTell) {
  const auto rightOf = [](const char* protocol, const char* kind) {
    const auto trials = scoreDrawnTrials({.count = 10}, {.protocol = protocol, .kinds = {kind}}, 20);
    return std::ranges::count_if(*trials, [](const ScoredTrial& trial) { return trial.score.right; });
  };
  EXPECT_GE(rightOf("paper", "gross_error"), 8);
  EXPECT_GE(rightOf("paper-slider", "unknown"), 6);
}

// If the session states an own effect, the effect must be named; otherwise the effect is uncatalogued.
TEST(TrialSeries, AnOwnEffectCountsAsOneOfTheCatalogue) {
  std::vector<Problem> problems;
  const auto own = examineOwnEffects({{.id = "dent",
                                       .formula = "radial = A*bump(s, 83°, 8°)",
                                       .parameters = {{.name = "A", .plausible = "0.2"}}}},
                                     problems);
  const BlindTrialOptions draw{.protocol = "full", .leastVisible = 12, .kinds = {"own:dent"}, .own = own};
  const auto trials = *scoreDrawnTrials({.count = 4, .withheld = true}, draw, 1);
  for (const ScoredTrial& trial : trials) {
    EXPECT_EQ(trial.score.trialClass, TrialClass::Unique);
    EXPECT_TRUE(trial.score.right) << trial.truth.id << " taken for " << trial.score.answer;
    EXPECT_EQ(trial.wrongWithout, false) << trial.truth.id;
  }
  EXPECT_EQ(summarise(trials).kinds.at("own:dent").right, (Tally{4, 4}));
  const BlindTrial drawn = *drawBlindTrial(draw, 1);
  SealedTruth unstated = drawn.seal;
  unstated.statesOwn = false;
  EXPECT_EQ(classOf(unstated), TrialClass::Unknown);
}

TEST(TrialSeries, NamesTheFileThatIsWrong) {
  EXPECT_THAT(scoreStoredTrials({}, "/no/such/folder").problem().text(),
              HasSubstr("/no/such/folder/truth.json: No such file or directory; a folder of trials holds"));
  const auto failing = [](std::size_t i) -> Result<TrialCase> {
    return Problem{"trial " + std::to_string(i)};
  };
  EXPECT_EQ(scoreTrials({.count = 9, .threads = 3}, failing).problem().text(), "trial 0");
}

TEST(TrialSummary, CountsByClassKindAndSize) {
  const auto trial = [](const std::string& kind, double visible, TrialScore score) {
    SealedTruth truth;
    truth.kind = kind;
    if (visible > 0) truth.visible = visible;
    return ScoredTrial{truth, std::move(score), {}};
  };
  using enum TrialClass;
  const TrialSummary summary = summarise({
      trial("none", 0, {.trialClass = None, .right = true, .answer = "within-noise"}),
      trial("none", 0, {.trialClass = None, .answer = "collimation", .detected = true, .covered = false}),
      trial("arc_lobing", 7,
            {.trialClass = Unique,
             .right = true,
             .answer = "arc_lobing",
             .detected = true,
             .named = true,
             .covered = true,
             .backToNoise = true}),
      trial("arc_lobing", 7.9, {.trialClass = Unique, .answer = "collimation", .detected = true}),
  });
  EXPECT_EQ(summary.count, 4u);
  EXPECT_EQ(summary.right.at(None), (Tally{1, 2}));
  EXPECT_EQ(summary.right.at(Unique), (Tally{1, 2}));
  EXPECT_EQ(summary.falseAlarms, (Tally{1, 2}));
  EXPECT_EQ(summary.covered, (Tally{1, 2}));
  EXPECT_EQ(summary.backToNoise, (Tally{1, 1}));
  EXPECT_EQ(summary.confusion.at("arc_lobing").at("collimation"), 1u);
  EXPECT_EQ(summary.kinds.at("none").quiet, (Tally{1, 2}));
  EXPECT_EQ(summary.kinds.at("arc_lobing").named, (Tally{1, 2}));
  EXPECT_EQ(summary.kinds.at("arc_lobing").measured, (Tally{}));
  ASSERT_EQ(summary.detection.size(), 1u);
  EXPECT_EQ(summary.detection[0].from, 6);
  EXPECT_EQ(summary.detection[0].detected, (Tally{2, 2}));
  EXPECT_EQ(summary.detection[0].named, (Tally{1, 2}));
}

}  // namespace
}  // namespace alidade
