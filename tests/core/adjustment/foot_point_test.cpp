#include "core/adjustment/foot_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace alidade {
namespace {

// The paper's arc, sighted 40″ off to the right and 30″ too high near its left end, with unequal σ.
const Circle circle{-0.8, 1.0, 402};
constexpr double distance = 2405;
const Whitening whitening{1 / Angle::fromArcseconds(2).radians(), 1 / Angle::fromArcseconds(3).radians()};

Direction<double> sighted(VerticalAngleRelation relation) {
  Direction<double> direction =
      observe(targetOnArc(circle.x, circle.y, circle.radius, 2.6), distance, relation);
  direction.a += Angle::fromArcseconds(40).radians();
  direction.e += Angle::fromArcseconds(30).radians();
  return direction;
}

double costAt(double phi, VerticalAngleRelation relation) {
  const auto model = observe(targetOnArc(circle.x, circle.y, circle.radius, phi), distance, relation);
  const auto s = sighted(relation);
  return std::hypot(whitening.horizontal * (s.a - model.a), whitening.vertical * (s.e - model.e));
}

class FootPointTest : public testing::TestWithParam<VerticalAngleRelation> {};

TEST_P(FootPointTest, IsTheNearestPointInUnitsOfSigma) {
  const FootPoint foot = footPoint(circle, distance, GetParam(), whitening, sighted(GetParam()));
  const double nearest = costAt(foot.phi, GetParam());
  EXPECT_NEAR(std::abs(foot.distance), nearest, 1e-9 * nearest);
  for (const double away : {-1e-3, -1e-5, 1e-5, 1e-3})
    EXPECT_GT(costAt(foot.phi + away, GetParam()), nearest) << away;
}

// Moving the circle by δ changes d by −gradient·δ, with φ found anew each time. The gradient is some 40 σ/mm;
// central differences over 1 µm err by 1e-8 σ/mm from rounding (1e-16 rad against 2″) and less from
// curvature.
TEST_P(FootPointTest, GradientMeetsTheChangeOfTheDistance) {
  const auto distanceFor = [&](double dx, double dy, double dr) {
    return footPoint({circle.x + dx, circle.y + dy, circle.radius + dr}, distance, GetParam(), whitening,
                     sighted(GetParam()))
        .distance;
  };
  const FootPoint foot = footPoint(circle, distance, GetParam(), whitening, sighted(GetParam()));
  constexpr double h = 1e-3, tolerance = 1e-6;
  EXPECT_NEAR((distanceFor(-h, 0, 0) - distanceFor(h, 0, 0)) / (2 * h), foot.gradient[0], tolerance);
  EXPECT_NEAR((distanceFor(0, -h, 0) - distanceFor(0, h, 0)) / (2 * h), foot.gradient[1], tolerance);
  EXPECT_NEAR((distanceFor(0, 0, -h) - distanceFor(0, 0, h)) / (2 * h), foot.gradient[2], tolerance);
}

INSTANTIATE_TEST_SUITE_P(Relations, FootPointTest,
                         testing::Values(VerticalAngleRelation::Exact, VerticalAngleRelation::Planar));

}  // namespace
}  // namespace alidade
