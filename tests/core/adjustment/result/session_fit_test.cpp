#include "core/adjustment/result/session_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using testing::HasSubstr;

std::string textOf(const std::vector<Finding>& findings) {
  std::string all;
  for (const Finding& finding : findings) all += finding.text + "\n";
  return all;
}

TEST(SessionFit, OfTableIAcceptsWithinItsTolerance) {
  const SessionFit fit = fitSession(test::paperMeasurement());
  ASSERT_EQ(fit.arcs.size(), 2u);
  ASSERT_EQ(fit.sigmas.size(), 2u);
  EXPECT_EQ(fit.verdict, Verdict::Accept);
  EXPECT_EQ(fit.arcAt(180), &fit.arcs[1]);
  EXPECT_EQ(fit.arcAt(90), nullptr);
}

// 1.96 mm between the radii of one rigid guideway, and 0.69 mm to the 2 mm setting: neither may pass in
// silence.
TEST(SessionFit, OfTableIDoesNotHideWhatItsReadingsLeaveOpen) {
  Measurement measurement = test::paperMeasurement();
  measurement.referenceIntersection = 2;
  const std::string findings = textOf(fitSession(measurement).findings);
  EXPECT_THAT(findings, HasSubstr("radii at 0° and 180° differ by 1.959 mm"));
  EXPECT_THAT(findings, HasSubstr("differs from the reference 2 mm by −0.692 mm"));
  EXPECT_THAT(findings, HasSubstr("0°: the readings scatter 7.3 times"));
  EXPECT_THAT(findings, HasSubstr("180°: the readings scatter 6.5 times"));
}

TEST(SessionFit, HasNoVerdictWithoutTolerance) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance.reset();
  const SessionFit fit = fitSession(measurement);
  EXPECT_TRUE(fit.intersection);
  EXPECT_FALSE(fit.verdict);
}

TEST(SessionFit, ReportsAMissingPosition) {
  Measurement measurement = test::paperMeasurement();
  measurement.arcs.pop_back();
  const SessionFit fit = fitSession(measurement);
  EXPECT_EQ(fit.arcs.size(), 1u);
  EXPECT_FALSE(fit.intersection);
  EXPECT_THAT(textOf(fit.findings), HasSubstr("no usable position at 180°"));
  EXPECT_THAT(textOf(fitSessionAsPublished(measurement).findings), HasSubstr("no usable position at 180°"));
}

TEST(SessionFit, FitsTheArcThatCanBeFitted) {
  Measurement measurement = test::paperMeasurement();
  measurement.arcs[0].sightings.resize(2);
  const SessionFit fit = fitSession(measurement);
  ASSERT_EQ(fit.arcs.size(), 1u);
  EXPECT_EQ(fit.arcs[0].axisDeg, 180);
  EXPECT_THAT(textOf(fit.findings), HasSubstr("The arc at 0° has readings of 2 places"));
  EXPECT_EQ(fit.findings.front().severity, Severity::Error);
}

TEST(SessionFit, NamesWhatItCannotEstimate) {
  Measurement measurement = test::paperMeasurement();
  measurement.effects = {"trunnion_tilt", "moonlight"};
  const SessionFit fit = fitSession(measurement);
  EXPECT_THAT(textOf(fit.findings), HasSubstr("“moonlight”, which is no effect"));
  ASSERT_EQ(fit.effects.size(), 1u);
  EXPECT_EQ(fit.effects[0].effect, "trunnion_tilt");
}

// Far more unknowns than these readings tell: priors hold them, and an answer comes with its larger
// uncertainty.
TEST(SessionFit, EstimatesTheWholeCatalogueAtOnce) {
  Measurement measurement = test::paperMeasurement();
  const double alone = fitSession(measurement).joint.degreesOfFreedom;
  for (const Effect& effect : effectCatalogue()) measurement.effects.emplace_back(effect.id);
  measurement.effects.emplace_back("collimation");  // named twice, estimated once
  const SessionFit fit = fitSession(measurement);
  EXPECT_EQ(fit.effects.size(),
            errorTermCount - 2);  // the jump's two are in no effect
  EXPECT_TRUE(fit.joint.converged());
  EXPECT_EQ(fit.joint.degreesOfFreedom, alone);
  ASSERT_TRUE(fit.intersection);
  EXPECT_TRUE(std::isfinite(fit.intersection->expanded));
}

TEST(SessionFit, ExchangingThePositionsChangesTheSignOnly) {
  Measurement measurement = test::paperMeasurement();
  const double value = fitSession(measurement).intersection->value;
  std::swap(measurement.arcs[0].axisDeg, measurement.arcs[1].axisDeg);
  EXPECT_DOUBLE_EQ(fitSession(measurement).intersection->value, -value);
}

// The 0° position was taken first, however the file has them: a drift estimated along must not know the
// order. 200″ of drift in the vertical circle, Δd −0.703.
TEST(SessionFit, ReversingThePositionsInTheFileChangesNothing) {
  Truth truth = drawTruth(7);
  ASSERT_FALSE(addEffect(truth, "vertical_drift=200"));
  truth.intersection = -0.703;
  Result<Session> simulated = simulate(*protocolByName("full"), truth, 7);
  ASSERT_TRUE(simulated);
  Session session = *std::move(simulated);
  session.model.effects = {"vertical_drift"};
  const SessionFit asTaken = fitSession(test::measurementOf(session));
  std::ranges::reverse(session.positions);
  const SessionFit reversed = fitSession(test::measurementOf(session));
  ASSERT_TRUE(asTaken.intersection && reversed.intersection);
  EXPECT_NEAR(asTaken.intersection->value, -0.703, 3 * asTaken.intersection->sigma);
  EXPECT_DOUBLE_EQ(reversed.intersection->value, asTaken.intersection->value);
  EXPECT_DOUBLE_EQ(reversed.intersection->expanded, asTaken.intersection->expanded);
  EXPECT_DOUBLE_EQ(reversed.effects.at(0).value, asTaken.effects.at(0).value);
}

}  // namespace
}  // namespace alidade
