#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "core/adjustment/result/session_fit.h"
#include "core/simulation/simulate.h"
#include "tests/support/found.h"
#include "tests/support/paper_table.h"

// Readings with little information end in a result with an honest uncertainty, or in a sentence; never in
// NaN.

namespace alidade {
namespace {

Measurement measured(const Protocol& protocol, std::uint64_t seed = 5) {
  Truth truth = drawTruth(seed);
  truth.intersection = 1;
  Measurement measurement = test::measurementOf(*simulate(protocol, truth, seed));
  measurement.coverage = 0.9999;
  return measurement;
}

Protocol planOf(int points, double from, double span) {
  Protocol protocol;
  protocol.points = points;
  protocol.first = Angle::fromDegrees(from);
  protocol.step = Angle::fromDegrees(span / std::max(1, points - 1));
  return protocol;
}

void expectFinite(const SessionFit& fit) {
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    for (const double value : {fit.arcs[i].circle.x, fit.arcs[i].circle.y, fit.arcs[i].circle.radius,
                               fit.arcs[i].chiSquare, fit.sigmas[i].x, fit.sigmas[i].y, fit.sigmas[i].radius,
                               fit.sigmas[i].radiusX, fit.sigmas[i].radiusY})
      EXPECT_TRUE(std::isfinite(value));
    for (const SightingResidual& residual : fit.arcs[i].residuals)
      EXPECT_TRUE(std::isfinite(residual.horizontal.radians() + residual.vertical.radians()));
  }
  if (!fit.intersection) return;
  EXPECT_TRUE(std::isfinite(fit.intersection->value));
  EXPECT_TRUE(std::isfinite(fit.intersection->expanded));
}

/// A result whose U at 99.99 % covers the truth, or an error in words. With little redundancy Student's k is
/// large, so σ alone would be too small.
void expectAnswerOrSentence(const SessionFit& fit) {
  expectFinite(fit);
  const bool error =
      std::ranges::find(fit.findings, Severity::Error, &FitFinding::severity) != fit.findings.end();
  ASSERT_NE(fit.intersection.has_value(), error);
  if (fit.intersection) {
    EXPECT_LT(std::abs(fit.intersection->value - 1), fit.intersection->expanded);
  }
}

TEST(PoorGeometry, FewPlacesOrAShortArcEndInAnAnswerOrASentence) {
  for (const int points : {1, 2, 3, 4, 5, 17})
    for (const double span : {0.5, 2.0, 5.0, 20.0, 60.0, 160.0})
      for (const double from : {10.0, 80.0, 150.0}) {
        if (from + span > 180) continue;
        SCOPED_TRACE(std::to_string(points) + " places over " + std::to_string(span) + "°");
        const Measurement measurement = measured(planOf(points, from, span));
        expectAnswerOrSentence(fitSession(measurement));
        Measurement known = measurement;
        known.radiusModel = RadiusModel::Known;
        known.nominalRadius = drawTruth(5).radius;
        expectAnswerOrSentence(fitSession(known));
      }
}

// Five places over 20° still determine a circle, though a poor one: the uncertainty has to say how poor.
TEST(PoorGeometry, TwentyDegreesAreAnswered) {
  const SessionFit fit = fitSession(measured(planOf(5, 80, 20)));
  ASSERT_TRUE(fit.intersection);
  EXPECT_GT(fit.intersection->sigma, 0.3);  // some 20 times that of the whole arc
  EXPECT_LT(fit.sigmas[0].radiusY, -0.99);
}

TEST(PoorGeometry, PlacesAllAlikeAreASentence) {
  for (const int points : {5, 17}) {
    Measurement measurement = measured(planOf(points, 90, 0));
    expectAnswerOrSentence(fitSession(measurement));
    for (ArcMeasurement& arc : measurement.arcs)
      for (Sighting& sighting : arc.sightings) {
        sighting.a = arc.sightings.front().a;
        sighting.e = arc.sightings.front().e;
      }
    const SessionFit fit = fitSession(measurement);
    EXPECT_TRUE(fit.arcs.empty());
    EXPECT_FALSE(fit.intersection);
    ASSERT_TRUE(test::found<session_finding::ArcMissing>(fit.findings));
    EXPECT_EQ(test::found<session_finding::ArcMissing>(fit.findings)->axisDeg, 0);
    EXPECT_EQ(fit.findings.front().severity, Severity::Error);
  }
}

TEST(PoorGeometry, OnePositionIsFittedAlone) {
  Protocol protocol = *protocolByName("full");
  protocol.axes = {180};
  const SessionFit fit = fitSession(measured(protocol));
  ASSERT_EQ(fit.arcs.size(), 1u);
  expectFinite(fit);
  EXPECT_FALSE(fit.intersection);
}

TEST(PoorGeometry, AnEmptySessionIsASentence) {
  Measurement measurement = measured(*protocolByName("paper"));
  for (ArcMeasurement& arc : measurement.arcs) arc.sightings.clear();
  EXPECT_TRUE(fitSession(measurement).arcs.empty());
  measurement.arcs.clear();
  EXPECT_FALSE(fitSession(measurement).findings.empty());
}

// Every effect of the catalogue at once on the poorest plan: the priors alone decide, and nothing diverges.
TEST(PoorGeometry, EveryEffectAtOnceIsAnswered) {
  for (const char* protocol : {"paper", "full"}) {
    Measurement measurement = measured(*protocolByName(protocol));
    for (const char* id :
         {"collimation", "trunnion_tilt", "vertical_index", "vertical_axis_tilt",
          "horizontal_circle_eccentricity", "vertical_circle_eccentricity", "horizontal_drift",
          "vertical_drift", "plane_tilt", "plane_offset", "arc_ellipticity", "arc_lobing", "gravity_sag",
          "plane_warp", "slider_scale", "slider_eccentricity", "vertical_angle_relation"})
      measurement.effects.emplace_back(id);
    const SessionFit fit = fitSession(measurement);
    expectFinite(fit);
    EXPECT_TRUE(fit.joint.converged()) << protocol;
    EXPECT_LT(std::abs(fit.intersection->value - 1), 5 * fit.intersection->sigma);
  }
}

// The time of a fit is proportional to its readings, not to their square: 16 times as many take some 16 times
// as long, compared with 256 times for the square. Processor time, so that a busy machine does not matter.
TEST(PoorGeometry, ManyReadingsTakeTimeInProportion) {
  const auto secondsOf = [](int points) {
    const Measurement measurement = measured(planOf(points, 10, 160));
    const std::clock_t start = std::clock();
    const SessionFit fit = fitSession(measurement);
    EXPECT_TRUE(fit.intersection);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  const double few = std::min(secondsOf(500), secondsOf(500));
  EXPECT_LT(secondsOf(8000), 100 * few + 0.2);
}

}  // namespace
}  // namespace alidade
