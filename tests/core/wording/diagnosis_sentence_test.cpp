#include "core/wording/diagnosis_sentence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

Diagnosis withOneCause(double before, double after) {
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::SingleCause;
  diagnosis.causes = {{.effect = "collimation",
                       .probability = 1,
                       .parameters = {},
                       .indistinguishableFrom = {},
                       .readings = {}}};
  diagnosis.gap = {.rms = before, .reducedChiSquare = 7.25, .pValue = 0};
  diagnosis.after = {.rms = after, .reducedChiSquare = 1.02, .pValue = 0.5};
  return diagnosis;
}

TEST(DiagnosisSentence, SaysShrinkOnlyOfWhatShrinks) {
  EXPECT_EQ(
      sentenceOf(withOneCause(2.9, 2.1)),
      "The gap is best explained by collimation. With the cause in the model, the residuals shrink from 2.9″ "
      "to 2.1″.");
  EXPECT_EQ(sentenceOf(withOneCause(2.9, 3)),
            "The gap is best explained by collimation. With the cause in the model, reduced χ² changes from "
            "7.25 to "
            "1.02; the unweighted residuals grow from 2.9″ to 3.0″.");
  EXPECT_THAT(sentenceOf(withOneCause(2.94, 2.93)), HasSubstr("shrink from 2.94″ to 2.93″."));
  EXPECT_THAT(sentenceOf(withOneCause(2.941, 2.938)), HasSubstr("stay at 2.94″."));
}

/// A closure that is off by 10 σ, and one within its σ.
const Closure open{.of = Closure::Of::Radius, .value = 1, .sigma = 0.1, .chance = 1e-23};
const Closure closed{.of = Closure::Of::Radius, .value = 0.01, .sigma = 0.1, .chance = 0.92};

TEST(DiagnosisSentence, SaysThatThePositionsCloseWhereTheyDidNotBefore) {
  const auto sentence = [](double after, const ClosureStep& step) {
    Diagnosis diagnosis = withOneCause(2.9, after);
    diagnosis.closures = {step, {.before = closed}};
    return sentenceOf(diagnosis);
  };
  const char *closes = "the two positions agree", *shrinks = "the residuals shrink from 2.9″ to 2.1″.";
  EXPECT_THAT(sentence(2.1, {.before = open, .after = closed}),
              EndsWith(std::string("With the cause in the model, ") + closes + ", and " + shrinks));
  EXPECT_THAT(sentence(2.9, {.before = open, .after = closed}),
              EndsWith(std::string("With the cause in the model, ") + closes + "."));
  EXPECT_THAT(sentence(2.1, {.before = open, .after = open}), EndsWith(std::string("model, ") + shrinks));
  EXPECT_THAT(sentence(2.1, {.before = open}), EndsWith(std::string("model, ") + shrinks))
      << "it is not known whether they do";
  EXPECT_THAT(sentence(2.1, {.before = closed, .after = closed}), EndsWith(std::string("model, ") + shrinks));
}

TEST(DiagnosisSentence, CallsEachCauseByItsName) {
  Diagnosis diagnosis = withOneCause(2.9, 2.1);
  diagnosis.verdict = DiagnosisVerdict::Ambiguous;
  diagnosis.causes[0].indistinguishableFrom = {"trunnion_tilt", "orientation_jump"};
  EXPECT_THAT(sentenceOf(diagnosis),
              HasSubstr("by collimation or by an indistinguishable cause: trunnion tilt or "
                        "a jump of the orientation."));
  diagnosis.verdict = DiagnosisVerdict::NotInCatalogue;
  diagnosis.shape = GapShape{.follows = "collimation along the way", .share = 0.5};
  EXPECT_EQ(sentenceOf(diagnosis),
            "Besides collimation there is a real gap that no effect of the catalogue explains; it follows "
            "the pattern “collimation along the way”.");
}

// Three places in one position: three conditions, three unknowns.
TEST(DiagnosisSentence, SaysWhereNothingChecksTheModel) {
  Protocol protocol = *protocolByName("paper");
  protocol.points = 3;
  protocol.step = Angle::fromDegrees(60);
  Session session = *simulate(protocol, drawTruth(1), 1);
  session.positions.pop_back();
  const Diagnosis diagnosis = *diagnose(test::measurementOf(session));
  EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::WithinNoise);  // no cause is named
  EXPECT_THAT(sentenceOf(diagnosis), HasSubstr("Nothing checks the model"));
  EXPECT_THAT(sentenceOf(diagnosis), Not(HasSubstr("agree")));
  EXPECT_TRUE(std::isnan(diagnosis.gap.reducedChiSquare));
  EXPECT_TRUE(std::isnan(diagnosis.gap.pValue));
}

TEST(DiagnosisSentence, TellsOfAGapThatIsWhatIsKnown) {
  Diagnosis diagnosis = withOneCause(12, 2);
  diagnosis.verdict = DiagnosisVerdict::WithinNoise;
  diagnosis.causes.clear();
  diagnosis.known = {
      {.effect = "collimation", .name = "collimation", .unit = "arcsec", .from = {}, .date = {}}};
  EXPECT_EQ(sentenceOf(diagnosis),
            "The known sizes (collimation) explain the gap: with them the residuals shrink from 12.0″ to "
            "2.0″, and the rest is within the stated noise.");
  diagnosis.gap.rms = 2.1;
  EXPECT_THAT(sentenceOf(diagnosis), HasSubstr("there is no gap to explain"));
}

}  // namespace
}  // namespace alidade
