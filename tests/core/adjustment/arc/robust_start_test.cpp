#include "core/adjustment/arc/robust_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/support/perfect_session.h"

namespace alidade::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Circle circle{0.7, -1.1, 400.4};

ArcMeasurement noisyArc(const Measurement& measurement, int points) {
  std::mt19937_64 generator(11);
  ArcMeasurement arc = perfectArc(measurement, circle, spread(points, 160));
  addNoise(arc, measurement, generator);
  return arc;
}

// 2″ at 2405 mm is 0.023 mm; a circle through the sound points is known to a few hundredths.
TEST(RobustStart, IsNotMovedBySevenOfSeventeenRows) {
  const Measurement measurement = usualMeasurement();
  ArcMeasurement arc = noisyArc(measurement, 17);
  for (const std::size_t row : {0u, 3u, 4u, 8u, 10u, 15u, 16u})
    arc.sightings[row].e = arc.sightings[row].e - Angle::fromDegrees(1 + 0.1 * static_cast<double>(row)),
    arc.sightings[row].a = arc.sightings[row].a - Angle::fromDegrees(1);
  const RobustStart start = robustStart(measurement, arc);
  EXPECT_NEAR(start.circle.x, circle.x, 0.3);
  EXPECT_NEAR(start.circle.y, circle.y, 0.3);
  EXPECT_NEAR(start.circle.radius, circle.radius, 0.3);
  EXPECT_THAT(start.apart, ElementsAre(0, 3, 4, 8, 10, 15, 16));
}

// Any rows may be wrong by any amount if ⌊n/2⌋ + 2 rows are right.
TEST(RobustStart, IsNotMovedByAnyMinority) {
  std::mt19937_64 random(21);
  const Measurement measurement = usualMeasurement();
  for (const int count : {9, 17, 40})
    for (int trial = 0; trial < 60; ++trial) {
      ArcMeasurement arc = noisyArc(measurement, count);
      std::vector<std::size_t> rows(static_cast<std::size_t>(count));
      std::iota(rows.begin(), rows.end(), std::size_t{0});
      std::ranges::shuffle(rows, random);
      rows.resize(static_cast<std::size_t>(count - count / 2 - 2));
      std::uniform_real_distribution<double> degrees(1, 8);
      for (const std::size_t row : rows) {
        Sighting& sighting = arc.sightings[row];
        sighting.e = sighting.e - Angle::fromDegrees(degrees(random));  // all to one side
        sighting.a = sighting.a - Angle::fromDegrees(degrees(random));
      }
      const RobustStart start = robustStart(measurement, arc);
      EXPECT_NEAR(start.circle.y, circle.y, 0.5) << count << ' ' << trial;
      EXPECT_NEAR(start.circle.radius, circle.radius, 0.5) << count << ' ' << trial;
    }
}

TEST(RobustStart, SetsNothingApartInASoundArc) {
  const Measurement measurement = usualMeasurement();
  EXPECT_THAT(robustStart(measurement, noisyArc(measurement, 17)).apart, IsEmpty());
  EXPECT_THAT(robustStart(measurement, noisyArc(measurement, 500)).apart, IsEmpty());
}

// Wherever the scale of the slider begins, also near 180°, where half the offsets are wrapped.
TEST(RobustStart, SetsSliderReadingsApart) {
  const Measurement measurement = usualMeasurement();
  for (const int count : {16, 17})
    for (const double zero : {0.02, std::numbers::pi, -std::numbers::pi / 2}) {
      ArcMeasurement arc = noisyArc(measurement, count);
      const std::vector<double> places = spread(count, 160);
      for (std::size_t i = 0; i < places.size(); ++i)
        arc.sightings[i].slider = wrapped(Angle::fromRadians(places[i] + zero));
      for (const std::size_t row : {5, 6})
        arc.sightings[row].slider = *arc.sightings[row].slider + Angle::fromDegrees(10);
      EXPECT_THAT(robustStart(measurement, arc).sliderApart, ElementsAre(5, 6)) << count << ' ' << zero;
    }
}

TEST(RobustStart, LeavesFewRowsTogether) {
  const Measurement measurement = usualMeasurement();
  ArcMeasurement arc = noisyArc(measurement, 5);
  arc.sightings[2].e = arc.sightings[2].e + Angle::fromDegrees(3);
  EXPECT_THAT(robustStart(measurement, arc).apart, IsEmpty());
}

}  // namespace
}  // namespace alidade::test
