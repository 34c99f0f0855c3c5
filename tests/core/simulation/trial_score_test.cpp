#include "core/simulation/trial_score.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Cause cause(const std::string& effect, std::vector<std::string> group = {}) {
  return {.effect = effect,
          .probability = 1,
          .parameters = {},
          .indistinguishableFrom = std::move(group),
          .readings = {}};
}

/// A diagnosis of these causes with the corresponding verdict.
Diagnosis diagnosed(std::vector<Cause> causes) {
  Diagnosis diagnosis;
  using enum DiagnosisVerdict;
  if (!causes.empty())
    diagnosis.verdict = causes.size() > 1                              ? SeveralCauses
                        : causes.front().indistinguishableFrom.empty() ? SingleCause
                                                                       : Ambiguous;
  diagnosis.causes = std::move(causes);
  return diagnosis;
}

Diagnosis unexplained() {
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::NotInCatalogue;
  return diagnosis;
}

SealedTruth truth(const std::string& kind, std::optional<double> visible = {},
                  std::vector<std::string> lookAlikes = {}) {
  SealedTruth truth;
  truth.kind = kind;
  truth.causes = {kind};
  truth.visible = visible;
  truth.lookAlikes = std::move(lookAlikes);
  return truth;
}

bool isRight(const SealedTruth& truth, const Diagnosis& diagnosis) {
  return scoreTrial(truth, diagnosis).right;
}

TEST(TrialScore, WantsSilenceWhereNothingIsWrong) {
  EXPECT_TRUE(isRight(truth("none"), diagnosed({})));
  EXPECT_FALSE(isRight(truth("none"), diagnosed({cause("collimation")})));
  EXPECT_FALSE(isRight(truth("none"), unexplained()));
  EXPECT_TRUE(scoreTrial(truth("none"), unexplained()).detected);
}

TEST(TrialScore, WantsAUniqueEffectFirst) {
  const SealedTruth unique = truth("arc_lobing", 6.0);
  EXPECT_EQ(classOf(unique), TrialClass::Unique);
  EXPECT_TRUE(isRight(unique, diagnosed({cause("arc_lobing")})));
  EXPECT_TRUE(isRight(unique, diagnosed({cause("arc_lobing"), cause("collimation")})));
  EXPECT_FALSE(isRight(unique, diagnosed({cause("collimation"), cause("arc_lobing")})));
  EXPECT_FALSE(isRight(unique, diagnosed({cause("collimation", {"arc_lobing"})})));
  EXPECT_FALSE(isRight(unique, diagnosed({})));
}

TEST(TrialScore, WantsALookAlikeInAGroupThatIsNotPadded) {
  const SealedTruth alike = truth("plane_warp", 12.0, {"trunnion_tilt", "vertical_drift"});
  EXPECT_EQ(classOf(alike), TrialClass::LookAlikes);
  EXPECT_TRUE(isRight(alike, diagnosed({cause("plane_warp")})));
  EXPECT_TRUE(isRight(alike, diagnosed({cause("trunnion_tilt", {"plane_warp", "vertical_drift"})})));
  EXPECT_TRUE(isRight(alike, diagnosed({cause("trunnion_tilt", {"plane_warp", "collimation"})})));
  EXPECT_FALSE(isRight(alike, diagnosed({cause("trunnion_tilt")})));
  EXPECT_FALSE(
      isRight(alike, diagnosed({cause("trunnion_tilt", {"plane_warp", "collimation", "gravity_sag"})})));
}

TEST(TrialScore, ForgivesSilenceAboutWhatIsFaint) {
  const SealedTruth faint = truth("plane_warp", 5.9, {"trunnion_tilt"});
  EXPECT_EQ(classOf(faint), TrialClass::Faint);
  EXPECT_TRUE(isRight(faint, diagnosed({})));
  EXPECT_TRUE(isRight(faint, diagnosed({cause("trunnion_tilt")})));
  EXPECT_FALSE(isRight(faint, diagnosed({cause("collimation")})));
  EXPECT_FALSE(isRight(faint, unexplained()));
}

TEST(TrialScore, WantsTheVeryReadings) {
  SealedTruth misread = truth("gross_error");
  misread.grossErrors = {{0, 1, 6, 1, ReadingKind::Vertical}, {180, 2, 3, 2, ReadingKind::Horizontal}};
  Cause found = cause("gross_error");
  const auto blame = [&](const GrossErrorCell& cell) {
    found.readings.push_back({.position = 0,
                              .row = 0,
                              .axisDeg = cell.axisDeg,
                              .round = cell.round,
                              .point = cell.point,
                              .face = cell.face,
                              .kind = cell.circle});
  };
  blame(misread.grossErrors[1]);
  EXPECT_FALSE(isRight(misread, diagnosed({found})));
  blame(misread.grossErrors[0]);
  EXPECT_TRUE(isRight(misread, diagnosed({found})));
  EXPECT_FALSE(isRight(misread, diagnosed({found, cause("collimation")})));
  found.readings[0].kind = ReadingKind::Vertical;
  EXPECT_FALSE(isRight(misread, diagnosed({found})));
}

TEST(TrialScore, WantsBothOfTwoCauses) {
  SealedTruth two = truth("two_causes");
  two.causes = {"collimation", "arc_lobing"};
  EXPECT_TRUE(isRight(two, diagnosed({cause("arc_lobing"), cause("collimation")})));
  EXPECT_FALSE(isRight(two, diagnosed({cause("arc_lobing")})));
  EXPECT_FALSE(isRight(two, diagnosed({})));
}

TEST(TrialScore, WantsTheUnknownLeftUnexplained) {
  EXPECT_TRUE(isRight(truth("unknown_harmonic"), unexplained()));
  EXPECT_FALSE(isRight(truth("unknown_dent"), diagnosed({cause("arc_lobing")})));
  EXPECT_FALSE(isRight(truth("unknown_dent"), diagnosed({})));
}

TEST(TrialScore, ComparesTheIntersectionAfterwards) {
  SealedTruth known = truth("collimation", 10.0);
  known.intersection = 1;
  Diagnosis diagnosis = diagnosed({cause("collimation")});
  diagnosis.afterwards = {.value = 1.05, .sigma = 0.02, .expanded = 0.04};
  EXPECT_EQ(scoreTrial(known, diagnosis).covered, false);
  diagnosis.afterwards->expanded = 0.06;
  EXPECT_EQ(scoreTrial(known, diagnosis).covered, true);
  diagnosis.after.pValue = 1e-5;
  EXPECT_EQ(scoreTrial(known, diagnosis).backToNoise, false);
  diagnosis.causes.clear();
  EXPECT_FALSE(scoreTrial(known, diagnosis).covered);
}

TEST(TrialScore, BlamesNothingWrongWithTheRightAnswerWithheld) {
  const SealedTruth withheld = truth("plane_warp", 12.0, {"trunnion_tilt"});
  EXPECT_FALSE(blamesWrongCause(withheld, unexplained()));
  EXPECT_FALSE(blamesWrongCause(withheld, diagnosed({cause("trunnion_tilt", {"collimation"})})));
  EXPECT_FALSE(blamesWrongCause(withheld, diagnosed({cause("collimation"), cause("gravity_sag")})));
  EXPECT_TRUE(blamesWrongCause(withheld, diagnosed({cause("collimation", {"trunnion_tilt"})})));
}

TEST(TrialScore, TakesWhatAThousandthOfNoiseExceedsForNoise) {
  const auto isBackToNoise = [](double pValue) {
    Diagnosis diagnosis = diagnosed({cause("arc_lobing")});
    diagnosis.after.pValue = pValue;
    return scoreTrial(truth("arc_lobing", 20.0), diagnosis).backToNoise;
  };
  EXPECT_EQ(isBackToNoise(0.002), true);
  EXPECT_EQ(isBackToNoise(0.0005), false);
}

}  // namespace
}  // namespace alidade
