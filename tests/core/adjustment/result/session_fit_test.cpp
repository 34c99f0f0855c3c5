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
#include "tests/support/found.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using namespace session_finding;
using test::found;

TEST(SessionFit, OfTableIAcceptsWithinItsTolerance) {
  const SessionFit fit = fitSession(test::paperMeasurement());
  ASSERT_EQ(fit.arcs.size(), 2u);
  ASSERT_EQ(fit.sigmas.size(), 2u);
  EXPECT_EQ(fit.verdict, Verdict::Accept);
  EXPECT_EQ(fit.arcAt(180), &fit.arcs[1]);
  EXPECT_EQ(fit.arcAt(90), nullptr);
}

// 1.96 mm between the radii of one rigid guideway.
TEST(SessionFit, OfTableIDoesNotHideWhatItsReadingsLeaveOpen) {
  const SessionFit fit = fitSession(test::paperMeasurement());
  const auto* radii = found<RadiiDiffer>(fit.findings);
  ASSERT_TRUE(radii);
  EXPECT_NEAR(radii->difference, 1.960, 0.0005);
  const auto scatters = [](const FitFinding& finding) {
    const auto* ofArc = std::get_if<ArcFinding>(&finding.what);
    return ofArc && std::holds_alternative<arc_finding::ScattersMore>(ofArc->what);
  };
  EXPECT_EQ(std::ranges::count_if(fit.findings, scatters), 2);
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
  const PublishedSessionFit published = fitSessionAsPublished(measurement);
  for (const auto* missing :
       {found<PositionMissing>(fit.findings), found<PositionMissing>(published.findings)}) {
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->axisDeg, 180);
  }
}

TEST(SessionFit, FitsTheArcThatCanBeFitted) {
  Measurement measurement = test::paperMeasurement();
  measurement.arcs[0].sightings.resize(2);
  const SessionFit fit = fitSession(measurement);
  ASSERT_EQ(fit.arcs.size(), 1u);
  EXPECT_EQ(fit.arcs[0].axisDeg, 180);
  const auto* missing = found<ArcMissing>(fit.findings);
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->axisDeg, 0);
  EXPECT_EQ(std::get<arc_fault::TooFewPlaces>(missing->why).places, 2u);
  EXPECT_EQ(fit.findings.front().severity, Severity::Error);
}

TEST(SessionFit, NamesWhatItCannotEstimate) {
  Measurement measurement = test::paperMeasurement();
  measurement.effects = {"trunnion_tilt", "moonlight"};
  const SessionFit fit = fitSession(measurement);
  ASSERT_TRUE(found<UnknownEffect>(fit.findings));
  EXPECT_EQ(found<UnknownEffect>(fit.findings)->id, "moonlight");
  ASSERT_EQ(fit.effects.size(), 1u);
  EXPECT_EQ(fit.effects[0].effect, "trunnion_tilt");
}

TEST(SessionFit, NamesWhatIsKnownOfNothing) {
  Measurement measurement = test::paperMeasurement();
  measurement.known = {{.effect = "collimation", .unit = "arcsec", .sigma = 1},
                       {.where = {.field = "instrument.known[1]"}, .effect = "collimation", .unit = "mm"}};
  const SessionFit fit = fitSession(measurement);
  ASSERT_TRUE(found<KnownOfNothing>(fit.findings));
  EXPECT_EQ(found<KnownOfNothing>(fit.findings)->unit, "mm");
}

// Far more unknowns than these readings determine: priors limit them, and the result has a larger
// uncertainty.
TEST(SessionFit, EstimatesTheWholeCatalogueAtOnce) {
  Measurement measurement = test::paperMeasurement();
  const double alone = fitSession(measurement).joint.degreesOfFreedom;
  for (const Effect& effect : effectCatalogue()) measurement.effects.emplace_back(effect.id);
  measurement.effects.emplace_back("collimation");  // named twice, estimated once
  const SessionFit fit = fitSession(measurement);
  EXPECT_EQ(fit.effects.size(),
            firstOwnTerm - 2);  // the jump's two belong to no effect
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

// The 0° position was taken first in any file order, so an estimated drift must be independent of it. 200″ of
// drift in the vertical circle, Δd −0.703.
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
