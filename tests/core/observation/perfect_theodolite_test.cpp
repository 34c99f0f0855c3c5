#include "core/observation/perfect_theodolite.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/observation/guideway.h"

namespace alidade {
namespace {

constexpr double distance = 2405;

TEST(PerfectTheodolite, ReadsTheAnglesOfTheSightLine) {
  for (const double x : {-900.0, -3.0, 0.0, 250.0})
    for (const double y : {-700.0, 0.0, 1.0, 650.0}) {
      const Direction<double> read =
          observe(PlanePoint<double>{x, y}, distance, VerticalAngleRelation::Exact);
      // The unit vector of the reading, converted back, has to hit the target, without a formula shared with
      // `observe`.
      const double slant = std::sqrt(x * x + y * y + distance * distance);
      EXPECT_NEAR(std::cos(read.e) * std::sin(read.a), x / slant, 1e-15);
      EXPECT_NEAR(std::sin(read.e), y / slant, 1e-15);
      EXPECT_NEAR(std::cos(read.e) * std::cos(read.a), distance / slant, 1e-15);
    }
}

TEST(PerfectTheodolite, PlanarRelationTakesTheVerticalCircleToReadYOverL) {
  const Direction<double> read =
      observe(PlanePoint<double>{380, 150}, distance, VerticalAngleRelation::Planar);
  EXPECT_DOUBLE_EQ(std::tan(read.e), 150 / distance);
  EXPECT_DOUBLE_EQ(std::tan(read.a), 380 / distance);
}

TEST(PerfectTheodolite, SightedPointIsTheInverse) {
  for (const auto relation : {VerticalAngleRelation::Exact, VerticalAngleRelation::Planar})
    for (const double x : {-4000.0, 0.0, 400.0})
      for (const double y : {-4000.0, 7.0, 400.0}) {
        const PlanePoint<double> back =
            sightedPoint(observe(PlanePoint<double>{x, y}, distance, relation), distance, relation);
        // A few rounding errors of the largest length here.
        EXPECT_NEAR(back.x, x, 1e-11);
        EXPECT_NEAR(back.y, y, 1e-11);
      }
}

TEST(Guideway, NearestArcAngleFindsTheTargetsOwnAngle) {
  const Circle circle{3, -2, 400};
  for (const double phi : {-3.0, -0.5, 0.0, 1.57, 3.1}) {
    const PlanePoint<double> target = targetOnArc(circle.x, circle.y, circle.radius, phi);
    EXPECT_NEAR(nearestArcAngle(circle, target), phi, 1e-14);
  }
}

}  // namespace
}  // namespace alidade
