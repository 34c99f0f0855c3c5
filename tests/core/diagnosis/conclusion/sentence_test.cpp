#include "core/diagnosis/conclusion/sentence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

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

TEST(Sentence, SaysShrinkOnlyOfWhatShrinks) {
  EXPECT_EQ(sentenceFor(withOneCause(2.9, 2.1)),
            "The gap is caused by collimation. With it in the model the residuals shrink from 2.9″ to 2.1″.");
  EXPECT_EQ(sentenceFor(withOneCause(2.9, 3)),
            "The gap is caused by collimation. With it in the model reduced χ² goes from 7.25 to 1.02; the "
            "residuals, counted alike, grow from 2.9″ to 3.0″.");
  EXPECT_THAT(sentenceFor(withOneCause(2.94, 2.93)), HasSubstr("shrink from 2.94″ to 2.93″."));
  EXPECT_THAT(sentenceFor(withOneCause(2.941, 2.938)), HasSubstr("stay at 2.94″."));
}

// Three places to each position: three conditions, three unknowns.
TEST(Sentence, SaysWhereNothingChecksTheModel) {
  Protocol protocol = *protocolByName("paper");
  protocol.points = 3;
  protocol.step = Angle::fromDegrees(60);
  const Diagnosis diagnosis = *diagnose(test::measurementOf(*simulate(protocol, drawTruth(1), 1)));
  EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::WithinNoise);  // no cause is named
  EXPECT_THAT(diagnosis.sentence, HasSubstr("Nothing checks the model"));
  EXPECT_THAT(diagnosis.sentence, Not(HasSubstr("agree")));
  EXPECT_TRUE(std::isnan(diagnosis.gap.reducedChiSquare));
  EXPECT_TRUE(std::isnan(diagnosis.gap.pValue));
}

}  // namespace
}  // namespace alidade
