#include "core/adjustment/visits.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace alidade {
namespace {

struct Row {
  int round, point, face;
  double a, e;  ///< rad
};

ArcMeasurement arcOf(const std::vector<Row>& rows) {
  ArcMeasurement arc;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Sighting sighting;
    sighting.row = i;
    sighting.round = rows[i].round;
    sighting.point = rows[i].point;
    sighting.face = rows[i].face;
    sighting.a = Angle::fromRadians(rows[i].a);
    sighting.e = Angle::fromRadians(rows[i].e);
    arc.sightings.push_back(sighting);
  }
  return arc;
}

// A way back, and the second face after the first: the slider goes 3, 1, 2, then round 2 before round 1 has
// ended.
TEST(Visits, AreInTheOrderOfTheirFirstRows) {
  const ArcMeasurement arc = arcOf(
      {{1, 3, 1, 0, 0}, {1, 1, 1, 0, 0}, {2, 2, 1, 0, 0}, {1, 2, 1, 0, 0}, {1, 1, 2, 0, 0}, {1, 3, 2, 0, 0}});
  std::vector<std::pair<int, int>> order;
  for (const Visit& visit : visitsOf(arc)) order.emplace_back(visit.round, visit.point);
  EXPECT_EQ(order, (std::vector<std::pair<int, int>>{{1, 3}, {1, 1}, {2, 2}, {1, 2}}));
}

TEST(Visits, HoldBothFacesAndTheirMean) {
  const std::vector<Visit> visits =
      visitsOf(arcOf({{1, 7, 1, 0.10, 0.20}, {1, 8, 1, 0.3, 0.4}, {1, 7, 2, 0.14, 0.26}}));
  ASSERT_EQ(visits.size(), 2u);
  ASSERT_EQ(visits[0].sightings.size(), 2u);
  EXPECT_EQ(visits[0].sightings[0], 0u);
  EXPECT_EQ(visits[0].sightings[1], 2u);
  EXPECT_EQ(visits[0].mean.rows, 2);
  EXPECT_DOUBLE_EQ(visits[0].mean.direction.a, 0.12);
  EXPECT_DOUBLE_EQ(visits[0].mean.direction.e, 0.23);
  EXPECT_EQ(visits[1].mean.rows, 1);
  EXPECT_DOUBLE_EQ(visits[1].mean.direction.a, 0.3);
}

TEST(Visits, SliderIsThatOfTheFirstRowThatHasOne) {
  ArcMeasurement arc = arcOf({{1, 1, 1, 0, 0}, {1, 1, 2, 0, 0}});
  EXPECT_EQ(sliderOf(arc, visitsOf(arc)[0]), nullptr);
  arc.sightings[1].slider = Angle::fromDegrees(20);
  EXPECT_EQ(sliderOf(arc, visitsOf(arc)[0]), &arc.sightings[1]);
  arc.sightings[0].slider = Angle::fromDegrees(10);
  EXPECT_EQ(sliderOf(arc, visitsOf(arc)[0]), &arc.sightings[0]);
}

}  // namespace
}  // namespace alidade
