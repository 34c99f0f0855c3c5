#include "core/observation/visits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
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

// A way back, and the second face after the first: the slider goes 3, 1, 2, then round 2 begins before round
// 1 has ended.
TEST(Visits, AreInTheOrderOfTheirFirstRows) {
  const ArcMeasurement arc = arcOf(
      {{1, 3, 1, 0, 0}, {1, 1, 1, 0, 0}, {2, 2, 1, 0, 0}, {1, 2, 1, 0, 0}, {1, 1, 2, 0, 0}, {1, 3, 2, 0, 0}});
  std::vector<std::pair<int, int>> order;
  for (const Visit& visit : visitsOf(arc)) order.emplace_back(visit.round, visit.point);
  EXPECT_EQ(order, (std::vector<std::pair<int, int>>{{1, 3}, {1, 1}, {2, 2}, {1, 2}}));
}

// The reference is a search row by row: for rounds up and down, ways there, back and crosswise, faces
// together or apart.
TEST(Visits, AreFoundInWhateverOrderTheRowsWereTaken) {
  std::mt19937 random(13);
  const auto below = [&](int end) { return std::uniform_int_distribution<>(0, end - 1)(random); };
  for (int set = 0; set < 500; ++set) {
    std::vector<Row> rows;
    const auto isThere = [&](int round, int point, int face) {
      return std::ranges::any_of(
          rows, [&](const Row& row) { return row.round == round && row.point == point && row.face == face; });
    };
    for (int leg = below(5); leg >= 0; --leg) {
      const int round = below(3), places = 1 + below(4), faces = 1 + below(2);
      const bool isBack = below(2) == 1;
      for (int i = 0; i < places; ++i)
        for (int face = 1; face <= faces; ++face) {
          const int point = below(8) == 0 ? below(9) : isBack ? places - i : i;
          if (!isThere(round, point, face)) rows.push_back({round, point, face, 0, 0});
        }
    }
    std::vector<std::pair<int, int>> places;
    std::vector<std::vector<std::size_t>> sightings;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::pair place(rows[i].round, rows[i].point);
      const auto at = std::ranges::find(places, place) - places.begin();
      if (at == std::ssize(places)) {
        places.push_back(place);
        sightings.emplace_back();
      }
      sightings[static_cast<std::size_t>(at)].push_back(i);
    }
    const std::vector<Visit> visits = visitsOf(arcOf(rows));
    ASSERT_EQ(visits.size(), places.size());
    for (std::size_t v = 0; v < visits.size(); ++v) {
      EXPECT_EQ(std::pair(visits[v].round, visits[v].point), places[v]);
      EXPECT_THAT(visits[v].sightings, testing::ElementsAreArray(sightings[v]));
    }
  }
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
