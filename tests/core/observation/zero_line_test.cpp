#include "core/observation/zero_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace alidade {
namespace {

struct Station {
  Measurement measurement;
  ArcMeasurement arc;
};

/// The instrument is `height` mm below the axis.
Station stationBelow(double height, ArcPlane plane, alidade::VerticalAngleRelation relation) {
  Station station;
  station.measurement.distance = 2405;
  station.measurement.plane = plane;
  station.measurement.relation = relation;
  station.arc.zeroElevation = Angle::fromRadians(std::atan2(height, 2405));
  return station;
}

TEST(ZeroLine, IsThePlainRelationAtALevelZero) {
  const Station level = stationBelow(0, ArcPlane::Square, alidade::VerticalAngleRelation::Exact);
  const Direction<double> seen = ZeroLine(level.measurement, level.arc).observe({300, 200});
  EXPECT_DOUBLE_EQ(seen.a, std::atan2(300, 2405));
  EXPECT_DOUBLE_EQ(seen.e, std::atan2(200, std::hypot(300, 2405)));
}

// If the plane is vertical, a point at the height of the zero line's foot is y + L tan e0 above the horizon.
TEST(ZeroLine, CountsElevationsFromThePlumbLine) {
  const Station below = stationBelow(50, ArcPlane::Vertical, alidade::VerticalAngleRelation::Exact);
  const ZeroLine line(below.measurement, below.arc);
  const double e0 = std::atan2(50, 2405);
  EXPECT_NEAR(line.observe({0, 0}).e, 0, 1e-15);
  EXPECT_NEAR(line.observe({400, 0}).e, std::atan2(50, std::hypot(400, 2405)) - e0, 1e-15);
  // (h/L) x²/2L², 59″ for 50 mm at 400 mm, to the next order of (x/L)².
  EXPECT_NEAR(-Angle::fromRadians(line.observe({400, 0}).e).arcseconds(), 59.3, 2);
}

// A plane square to the zero, compared with its rotation about the trunnion axis written out.
TEST(ZeroLine, TurnsASquarePlaneWithTheZero) {
  const Station below = stationBelow(50, ArcPlane::Square, alidade::VerticalAngleRelation::Exact);
  const double e0 = std::atan2(50, 2405), x = 300, y = 350;
  const double up = y * std::cos(e0) + 2405 * std::sin(e0), forward = 2405 * std::cos(e0) - y * std::sin(e0);
  const Direction<double> seen = ZeroLine(below.measurement, below.arc).observe({x, y});
  EXPECT_NEAR(seen.a, std::atan2(x, forward), 1e-15);
  EXPECT_NEAR(seen.e, std::atan2(up, std::hypot(x, forward)) - e0, 1e-15);
}

TEST(ZeroLine, FindsThePointAgain) {
  for (const ArcPlane plane : {ArcPlane::Vertical, ArcPlane::Square})
    for (const auto relation :
         {alidade::VerticalAngleRelation::Exact, alidade::VerticalAngleRelation::Planar})
      for (const double height : {-300.0, -5.0, 0.0, 5.0, 50.0}) {
        const Station station = stationBelow(height, plane, relation);
        const ZeroLine line(station.measurement, station.arc);
        const PlanePoint<double> found = line.sightedPoint(line.observe({-321, 123}));
        EXPECT_NEAR(found.x, -321, 1e-9);
        EXPECT_NEAR(found.y, 123, 1e-9);
        const Direction<double> level = line.levelled(line.observe({-321, 123}));
        const PlanePoint<double> inKernel = sightedPoint(level, 2405.0, relation);
        EXPECT_NEAR(inKernel.x, -321, 1e-9);
        EXPECT_NEAR(inKernel.y - line.height(), 123, 1e-9);
      }
}

}  // namespace
}  // namespace alidade
