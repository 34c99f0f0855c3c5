#include "core/wording/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::HasSubstr;

TEST(VerdictSentence, StatesTheNumbersItRestsOn) {
  EXPECT_EQ(
      verdictSentence(1.30764, 0.2117, 2.5, 0.95),
      "The intersection was measured as 1.31 mm ± 0.21 mm (95 % coverage); it lies within the tolerance of "
      "± 2.5 mm, its uncertainty included.");
  EXPECT_THAT(verdictSentence(1, 0.01, 0.5, 0.95), HasSubstr("lies outside"));
  EXPECT_THAT(verdictSentence(1, 0.01, 1, 0.95), HasSubstr("cannot be said"));
}

TEST(VerdictSentence, IsThatOfTheFit) {
  Measurement measurement = test::paperMeasurement();
  const SessionFit fit = fitSession(measurement);
  EXPECT_EQ(verdictSentence(measurement, fit),
            verdictSentence(fit.intersection->value, fit.intersection->expanded, *measurement.tolerance,
                            measurement.coverage));
  measurement.tolerance.reset();
  EXPECT_EQ(verdictSentence(measurement, fitSession(measurement)), "");
}

TEST(VerdictSentence, SaysWhyItIsWithheld) {
  const Measurement measurement = test::paperMeasurement();
  SessionFit fit = fitSession(measurement);
  fit.lengthsInDoubt = LengthsInDoubt{.distance = 2.405, .nominalRadius = 400};
  EXPECT_EQ(verdictSentence(measurement, fit),
            "The verdict is withheld: no theodolite sights anything at a distance of 2.405 mm: check the "
            "distance L (geometry.distance_mm: 2.405) and the nominal radius R0 (geometry.radius_mm: 400), "
            "both in mm.");
  fit.lengthsInDoubt =
      LengthsInDoubt{.distance = 2405, .nominalRadius = 200, .radius = LengthsInDoubt::Radius{180, 99.6}};
  EXPECT_THAT(verdictSentence(measurement, fit),
              HasSubstr("withheld: the radius fitted at 180° is 100 % off the nominal one"));
}

}  // namespace
}  // namespace alidade
