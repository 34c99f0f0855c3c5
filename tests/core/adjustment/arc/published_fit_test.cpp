#include "core/adjustment/arc/published_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

/// The tolerances are half a unit of the last printed digit.
constexpr double fourDigits = 0.5e-4, threeDigits = 0.5e-3;

class PublishedFitOfTableI : public testing::Test {
 protected:
  const PublishedSessionFit m_fit = fitSessionAsPublished(test::paperMeasurement());
  const AsPrinted& m_upper = m_fit.arcs.at(0).asPrinted;
  const AsPrinted& m_lower = m_fit.arcs.at(1).asPrinted;
};

TEST_F(PublishedFitOfTableI, ReproducesEveryPrintedDigitOfTheCentresAndTheIntersection) {
  EXPECT_NEAR(m_upper.x, -0.972, threeDigits);
  EXPECT_NEAR(m_upper.y, 1.8143, fourDigits);
  EXPECT_NEAR(m_lower.x, -1.492, threeDigits);
  EXPECT_NEAR(m_lower.y, -2.0538, fourDigits);
  EXPECT_NEAR(*m_fit.intersectionAsPrinted, 1.934, threeDigits);
}

// The printed ΔR is the increment of the second iteration, not the difference from the nominal radius.
TEST_F(PublishedFitOfTableI, ReproducesThePrintedRadiusCorrections) {
  EXPECT_NEAR(m_upper.deltaRadius, -0.0091, fourDigits);
  EXPECT_NEAR(m_lower.deltaRadius, -0.0318, fourDigits);
  EXPECT_NEAR(m_fit.arcs[0].arc.circle.radius, 400 + 2.7061 - 0.0091, 2 * fourDigits);
  EXPECT_NEAR(m_fit.arcs[1].arc.circle.radius, 400 + 5.0755 - 0.0318, 2 * fourDigits);
}

// Printed: Δθx 2.8e-5 and 3.6e-5, Δθy −3.9e-5 and −1.7e-5. The system's Δθx have these digits but are a
// thousand times larger, one with the opposite sign; its Δθy are unrelated to the printed ones.
TEST_F(PublishedFitOfTableI, DoesNotReproduceThePrintedTilts) {
  EXPECT_NEAR(m_upper.thetaX, 0.02835, 0.5e-5);
  EXPECT_NEAR(m_lower.thetaX, -0.03602, 0.5e-5);
  EXPECT_NEAR(m_upper.thetaY, -0.00491, 0.5e-5);
  EXPECT_NEAR(m_lower.thetaY, -0.00018, 0.5e-5);
  EXPECT_NEAR(std::abs(m_upper.thetaX) / 1000, 2.8e-5, 0.5e-6);
  EXPECT_NEAR(std::abs(m_lower.thetaX) / 1000, 3.6e-5, 0.5e-6);
}

// The paper's y points down with zenith angles; the program's points up.
TEST_F(PublishedFitOfTableI, GivesItsCentresYUp) {
  EXPECT_EQ(m_fit.arcs[0].arc.circle.y, -m_upper.y);
  EXPECT_NEAR(*m_fit.intersection, -1.934, threeDigits);
}

PublishedSessionFit ofErrorFreeReadings(double intersection) {
  Measurement measurement = test::usualMeasurement();
  for (const int axisDeg : {0, 180}) {
    const double y = axisDeg == 0 ? intersection : -intersection;
    const double middle = axisDeg == 0 ? 90 : 270;
    measurement.arcs.push_back(
        test::perfectArc(measurement, {0, y, 400}, test::spread(17, 160, middle), axisDeg));
  }
  return fitSessionAsPublished(measurement);
}

// The published agreement with its 2 mm setting is a coincidence: on error-free readings of a real (exact)
// theodolite the method is wrong by 3 mm, as its tilt columns absorb what the planar relation omits.
TEST(PublishedFit, IsWrongByMillimetresOnErrorFreeReadings) {
  EXPECT_NEAR(*ofErrorFreeReadings(0).intersection, -3.0, 0.1);
  EXPECT_NEAR(*ofErrorFreeReadings(2).intersection, -1.0, 0.1);
  EXPECT_NEAR(ofErrorFreeReadings(0).arcs[0].asPrinted.thetaX, 0.030, 0.002);
}

// On readings by the planar relation, which the method assumes, the centres are true and there is no tilt.
TEST(PublishedFit, IsConsistentWithItsOwnRelation) {
  Measurement measurement = test::usualMeasurement();
  measurement.relation = VerticalAngleRelation::Planar;
  const Circle truth{0.5, -0.8, 400.05};
  const auto fit =
      fitArcAsPublished(measurement, test::perfectArc(measurement, truth, test::spread(17, 160)));
  ASSERT_TRUE(fit);
  // The linear system omits Δx² + Δy² (0.9 mm²), equivalent to a radius change of about 0.9/2R = 0.0011 mm.
  EXPECT_NEAR(fit->arc.circle.x, truth.x, 0.002);
  EXPECT_NEAR(fit->arc.circle.y, truth.y, 0.002);
  EXPECT_NEAR(fit->arc.circle.radius, truth.radius, 0.002);
  EXPECT_NEAR(fit->asPrinted.thetaX, 0, 1e-4);
}

TEST(PublishedFit, NeedsFivePlaces) {
  const Measurement measurement = test::usualMeasurement();
  const auto fit =
      fitArcAsPublished(measurement, test::perfectArc(measurement, {0, 0, 400}, test::spread(4, 160)));
  ASSERT_FALSE(fit);
  EXPECT_EQ(std::get<arc_fault::TooFewForPublished>(fit.problem()).places, 4);
}

TEST(PublishedFit, RefusesRepeatedPlaces) {
  const Measurement measurement = test::usualMeasurement();
  EXPECT_FALSE(fitArcAsPublished(measurement,
                                 test::perfectArc(measurement, {0, 0, 400}, std::vector<double>(8, 1.0))));
}

}  // namespace
}  // namespace alidade
