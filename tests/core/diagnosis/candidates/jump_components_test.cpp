#include "core/diagnosis/candidates/jump_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

std::ptrdiff_t momentsSoughtBy(const std::string& protocol) {
  const Session session = *simulate(*protocolByName(protocol), drawTruth(5), 5);
  const GapModel model = *modelOf(*examine(session).measurement);
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options));
  return std::ranges::count_if(jumpComponents(leftover), [](const Component& c) { return !c.onlyRow(); });
}

// Rows alone in their visits: 34 rows have 33 moments between them. One after the first and one before the
// last row of each position do not count. A second face or the slider distinguishes a jump from a gross
// error.
TEST(JumpComponents, StepIsNotSoughtWhereItIsAMisreading) {
  EXPECT_EQ(momentsSoughtBy("paper"), 33 - 4);
  EXPECT_EQ(momentsSoughtBy("there-and-back"), 67 - 4);
  EXPECT_EQ(momentsSoughtBy("paper-slider"), 33);
  EXPECT_EQ(momentsSoughtBy("two-face"), 135);
}

// At the ends of the arc, 10° and 170°, the horizontal circle shows almost all of a gross error. A jump there
// would leave exactly the same trace.
TEST(JumpComponents, SlipInTheLastRowOfAPositionIsNoStep) {
  for (const int axis : {0, 180})
    for (const int point : {1, 17}) {
      SCOPED_TRACE(std::to_string(axis) + "°, point " + std::to_string(point));
      Truth truth = drawTruth(5);
      truth.grossErrors = {
          {.axisDeg = axis, .point = point, .horizontal = Angle::fromArcseconds(60), .vertical = {}}};
      const Diagnosis diagnosis =
          *diagnose(*examine(*simulate(*protocolByName("paper"), truth, 5)).measurement);
      ASSERT_EQ(diagnosis.causes.size(), 1u);
      ASSERT_EQ(diagnosis.causes[0].readings.size(), 1u) << diagnosis.causes[0].effect;
      const ReadingDeviation& blamed = diagnosis.causes[0].readings[0];
      EXPECT_EQ(blamed.axisDeg, axis);
      EXPECT_EQ(blamed.point, point);
      EXPECT_EQ(blamed.kind, ReadingKind::Horizontal);
    }
}

/// A truth with a jump before row `row` of 34.
Truth knockedBefore(int row) {
  Truth truth = drawTruth(5);
  truth.jump = {.moment = (row - 1.5) / 33,
                .horizontal = Angle::fromArcseconds(30),
                .vertical = Angle::fromArcseconds(-40)};
  return truth;
}

// The tripod was knocked before the last row of the first position. The residuals cannot distinguish this
// from a misreading, or from a jump after that row. The different zero of the second position can.
TEST(JumpComponents, StepBeforeTheLastRowOfAPositionShowsInTheNext) {
  const Truth truth = knockedBefore(17);
  const Diagnosis diagnosis = *diagnose(*examine(*simulate(*protocolByName("paper"), truth, 5)).measurement);
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  EXPECT_EQ(diagnosis.causes[0].effect, "orientation_jump");
  EXPECT_NEAR(diagnosis.causes[0].parameters.back().value, 17.5, 0.5);
  EXPECT_LT(std::abs(diagnosis.afterwards->value - truth.intersection), diagnosis.afterwards->expanded);
}

// A jump before the very last row leaves the trace of a misreading of that row. So the row is blamed, and the
// jump is named as its look-alike.
TEST(JumpComponents, StepThatLooksLikeAMisreadingIsNamedBesideIt) {
  const Truth truth = knockedBefore(34);
  const Diagnosis diagnosis = *diagnose(*examine(*simulate(*protocolByName("paper"), truth, 5)).measurement);
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  EXPECT_EQ(diagnosis.causes[0].effect, "gross_error");
  EXPECT_EQ(diagnosis.causes[0].indistinguishableFrom, std::vector<std::string>{"orientation_jump"});
  EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::Ambiguous);
  ASSERT_EQ(diagnosis.causes[0].readings.size(), 1u);
  EXPECT_EQ(diagnosis.causes[0].readings.front().axisDeg, 180);
  EXPECT_EQ(diagnosis.causes[0].readings.front().point, 17);
  EXPECT_LT(std::abs(diagnosis.afterwards->value - truth.intersection), diagnosis.afterwards->expanded);
  ASSERT_FALSE(diagnosis.advice.empty());
  EXPECT_EQ(diagnosis.advice.front().separates,
            (std::vector<std::string>{"gross_error", "orientation_jump"}));
  EXPECT_FALSE(diagnosis.advice.front().ofUndetectable);
}

// If misread values are excluded, only the jump leaves this trace.
TEST(JumpComponents, StepIsFoundAtTheLastRowWhereNothingIsMisread) {
  const Diagnosis diagnosis =
      *diagnose(*examine(*simulate(*protocolByName("paper"), knockedBefore(34), 5)).measurement,
                {.without = {"gross_error"}});
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  EXPECT_EQ(diagnosis.causes[0].effect, "orientation_jump");
}

// 300″ are five plausible sizes of a jump, but a gross error. With the slider a jump appears in both circles.
TEST(JumpComponents, LargeSlipIsNoStep) {
  Truth truth = drawTruth(5);
  truth.grossErrors = {{.axisDeg = 0, .point = 17, .horizontal = Angle::fromArcseconds(300), .vertical = {}}};
  const Diagnosis diagnosis = *diagnose(*examine(*simulate(*protocolByName("paper"), truth, 5)).measurement);
  EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::SingleCause);
  const Diagnosis knocked =
      *diagnose(*examine(*simulate(*protocolByName("paper-slider"), knockedBefore(17), 5)).measurement);
  ASSERT_FALSE(knocked.causes.empty());
  EXPECT_EQ(knocked.causes[0].effect, "orientation_jump");
}

// Bayes' theorem for jumps that are normal about zero with a width of 0.3 or 1, equally probable. A visible
// jump of 0.4 has the narrow width with odds of e^(0.08 − 0.8889)/0.3. A jump far larger than both has its
// own size as width.
TEST(JumpComponents, ThatAreSmallWhereTheyShowAreNotTakenForLargeElsewhere) {
  const std::vector<JumpComponent> components = wrongZeros(Leftover(
      linearise(test::trialMeasurement("paper"),
                *closedModelOf(*modelOf(test::trialMeasurement("paper")))->fit, {.isClosed = true})));
  ASSERT_EQ(components.size(), 2u);
  const double odds = std::exp(0.08 - 0.16 / 0.18) / 0.3;
  const double expected = std::sqrt((odds * 0.09 + 1) / (odds + 1));
  for (const JumpComponent& component : components) {
    EXPECT_NEAR(component.widthOfFit(1, Eigen::Vector2d(-0.4, 0)), expected, 1e-12);
    EXPECT_NEAR(component.widthOfFit(0.3, Eigen::Vector2d(0.1, 0.4)), expected, 1e-12);
    EXPECT_NEAR(component.widthOfFit(1, Eigen::Vector2d(0, 20)), 20, 1e-12);
  }
}

}  // namespace
}  // namespace alidade
