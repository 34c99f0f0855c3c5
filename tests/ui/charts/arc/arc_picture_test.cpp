#include "ui/charts/arc/arc_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/session/session_file.h"
#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

double largestOffset(const ArcPicture& picture) {
  double largest = 0;
  for (const DrawnSighting& s : picture.sightings)
    largest = std::max(largest, std::hypot(s.sighted.x - s.adjusted->x, s.sighted.y - s.adjusted->y));
  return largest;
}

TEST(ArcPicture, ShowsEverySightingOnItsArc) {
  const Evaluation evaluation = evaluate(paperSession());
  const ArcPicture picture = arcPicture(evaluation);
  ASSERT_EQ(picture.arcs.size(), 2u);
  ASSERT_EQ(picture.sightings.size(), 34u);
  for (const DrawnSighting& sighting : picture.sightings) {
    ASSERT_TRUE(sighting.adjusted);
    const Circle& circle = evaluation.fit.arcAt(sighting.axisDeg)->circle;
    EXPECT_NEAR(std::hypot(sighting.adjusted->x - circle.x, sighting.adjusted->y - circle.y), circle.radius,
                1e-9);
    EXPECT_GT(sighting.sighted.y * (sighting.axisDeg == 0 ? 1 : -1), 0);  // 0° above, 180° below
  }
}

TEST(ArcPicture, RunsTheArcsOverTheSightedAngles) {
  const ArcPicture picture = arcPicture(evaluate(paperSession()));
  EXPECT_NEAR(picture.arcs[0].firstAngle * 180 / M_PI, 10.3, 0.2);
  EXPECT_NEAR(picture.arcs[0].lastAngle * 180 / M_PI, 170.5, 0.2);
  EXPECT_NEAR(picture.arcs[1].firstAngle * 180 / M_PI, -169.7, 0.2);
  EXPECT_NEAR(picture.arcs[1].lastAngle * 180 / M_PI, -9.4, 0.2);
}

// The first position covers the right half of the arc, the repeat the left half.
TEST(ArcPicture, RunsAnArcOverAllPositionsOfItsAxis) {
  Session session = sessionTakenAt({0, 180, 0});
  session.positions[0].readings.resize(9);
  auto& again = session.positions[2].readings;
  again.erase(again.begin(), again.begin() + 8);
  const ArcPicture picture = arcPicture(evaluate(session));
  ASSERT_EQ(picture.arcs.size(), 2u) << "one for each axis";
  EXPECT_NEAR(picture.arcs[0].firstAngle * 180 / M_PI, 10, 1);
  EXPECT_NEAR(picture.arcs[0].lastAngle * 180 / M_PI, 170, 1);
  ASSERT_EQ(picture.sightings.size(), 9u + 17 + 9);
  EXPECT_EQ(picture.sightings.front().repeat, 1);
  EXPECT_EQ(picture.sightings.back().repeat, 2);
  for (const DrawnSighting& sighting : picture.sightings) EXPECT_TRUE(sighting.adjusted);
}

TEST(ArcPicture, ExaggeratesTheLargestResidualToATenthOfTheRadiusOrSo) {
  for (const char* scatter : {"none", "some"}) {
    Session session = paperSession();
    if (*scatter == 's') session.positions[0].readings[8].vertical = "80°35'30\"";  // an error of 6′
    const ArcPicture picture = arcPicture(evaluate(session));
    const double drawn = picture.exaggeration * largestOffset(picture) / picture.arcs[0].circle.radius;
    EXPECT_LE(drawn, 0.16);
    EXPECT_GE(drawn, 0.16 / 2.5);
    const double lead =
        picture.exaggeration / std::pow(10, std::floor(std::log10(picture.exaggeration) + 1e-9));
    EXPECT_TRUE(std::abs(lead - 1) < 1e-6 || std::abs(lead - 2) < 1e-6 || std::abs(lead - 5) < 1e-6) << lead;
  }
}

TEST(ArcPicture, DrawsTheResidualFromTheAdjustedTowardsTheSightedPoint) {
  const ArcPicture picture = arcPicture(evaluate(paperSession()));
  const DrawnSighting& sighting = picture.sightings.front();
  const PlanePoint<double> end = picture.residualEnd(sighting);
  EXPECT_NEAR(end.x - sighting.adjusted->x,
              picture.exaggeration * (sighting.sighted.x - sighting.adjusted->x), 1e-9);
  EXPECT_NEAR(end.y - sighting.adjusted->y,
              picture.exaggeration * (sighting.sighted.y - sighting.adjusted->y), 1e-9);
}

/// A collimation of 18″ moves the sighted point in the arc plane by L · 18″ = 0.21 mm. Once estimated, it
/// leaves only noise: 0.06 mm for 5″.
TEST(ArcPicture, DrawsNoEffectThatIsEstimatedAlongAsResidual) {
  const Result<Session> session = loadSession(samplePath(QStringLiteral("two-faces.alidade")).toStdString());
  ASSERT_TRUE(session);
  const ArcPicture picture = arcPicture(evaluate(*session));
  EXPECT_GT(largestOffset(picture), 0.2);
  double largest = 0;
  for (const DrawnSighting& sighting : picture.sightings)
    largest = std::max(largest, std::hypot(sighting.residual.x, sighting.residual.y));
  EXPECT_LT(largest, 0.08);
  EXPECT_GT(largest, 0.02);
}

TEST(ArcPicture, KeepsExcludedRowsApart) {
  Session session = paperSession();
  session.positions[1].readings[4].excluded = true;
  const ArcPicture picture = arcPicture(evaluate(session));
  EXPECT_EQ(picture.sightings.size(), 33u);
  ASSERT_EQ(picture.excluded.size(), 1u);
  EXPECT_EQ(picture.excluded[0].ref, (SightingRef{1, 4}));
  EXPECT_NEAR(std::hypot(picture.excluded[0].sighted.x, picture.excluded[0].sighted.y), 404, 3);
}

TEST(ArcPicture, LeavesOutExcludedRowsThatMeanNothing) {
  Session session = paperSession();
  session.positions[1].readings[4].excluded = true;
  session.positions[1].readings[4].vertical = "blown away";
  EXPECT_TRUE(arcPicture(evaluate(session)).excluded.empty());
}

TEST(ArcPicture, IsEmptyWithoutReadings) {
  EXPECT_TRUE(arcPicture({}).isEmpty());
  EXPECT_TRUE(arcPicture(evaluate(blankSession())).isEmpty());
}

TEST(ArcPicture, ShowsPointsWithoutAFit) {
  Session session = paperSession();
  for (Position& position : session.positions) position.readings.resize(2);
  const ArcPicture picture = arcPicture(evaluate(session));
  EXPECT_TRUE(picture.arcs.empty());
  EXPECT_EQ(picture.sightings.size(), 4u);
  EXPECT_FALSE(picture.sightings[0].adjusted);
  EXPECT_DOUBLE_EQ(picture.exaggeration, 1);
}

TEST(ArcPicture, HoldsEachCentreInTheEllipseOfItsCovariance) {
  const Evaluation evaluation = evaluate(paperSession());
  const DrawnIntersection drawn = *arcPicture(evaluation).intersection;
  const Intersection& found = *evaluation.fit.intersection;
  const double factor = ellipseFactor(found.coverage, found.effectiveDegreesOfFreedom);
  EXPECT_GT(factor, found.coverageFactor) << "two dimensions want more than one";
  for (const auto& [ellipse, arc] : {std::pair(drawn.upperEllipse, 0), std::pair(drawn.lowerEllipse, 1)}) {
    // The box around the ellipse has both σ as half sides, whatever their correlation.
    EXPECT_NEAR(ellipse.reach().x, factor * evaluation.fit.sigmas[arc].x, 1e-9);
    EXPECT_NEAR(ellipse.reach().y, factor * evaluation.fit.sigmas[arc].y, 1e-9);
  }
  EXPECT_EQ(drawn.tolerance, 2.5);
  Session without = paperSession();
  without.acceptance.toleranceMm.clear();
  EXPECT_FALSE(arcPicture(evaluate(without)).intersection->tolerance);
}

TEST(ArcPicture, TurnsTheEllipseWithTheCorrelation) {
  const DrawnEllipse ellipse = ellipseOf(2, 2, 1, 3);  // eigenvalues 3 and 1
  EXPECT_NEAR(ellipse.major, 3 * std::sqrt(3), 1e-12);
  EXPECT_NEAR(ellipse.minor, 3, 1e-12);
  EXPECT_NEAR(ellipse.direction, M_PI / 4, 1e-12);
  EXPECT_NEAR(ellipseOf(2, 2, -1, 3).direction, -M_PI / 4, 1e-12);
  EXPECT_NEAR(std::abs(ellipseOf(1, 4, 0, 1).direction), M_PI / 2, 1e-12);
}

// χ² of two degrees of freedom at 95 % is 5.991, Fisher's quantile of 2 and 10 is 4.103.
TEST(ArcPicture, WidensTheEllipseWhereTheScatterIsEstimated) {
  EXPECT_NEAR(ellipseFactor(0.95, std::numeric_limits<double>::infinity()), std::sqrt(5.991), 1e-3);
  EXPECT_NEAR(ellipseFactor(0.95, 10), std::sqrt(2 * 4.103), 1e-3);
}

}  // namespace
}  // namespace alidade::ui
