#include "core/adjustment/result/closures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

Measurement withArcs(const Circle& at0, const Circle& at180, int points = 13) {
  Measurement measurement = test::usualMeasurement();
  measurement.arcs = {test::perfectArc(measurement, at180, test::spread(points, 140, -90), 180),
                      test::perfectArc(measurement, at0, test::spread(points, 140))};
  return measurement;
}

std::vector<Closure> closuresOf(const Measurement& measurement) {
  return alidade::closuresOf(measurement, fitSession(measurement).joint);
}

// The result is the same for any order of the positions in the file. With exact zeros and distance the arcs
// are independent.
TEST(Closures, AreTheDifferencesOfThePositions) {
  const Measurement measurement = withArcs({0.3, 1, 400.2}, {-0.1, -1, 400.5});
  const SessionFit fit = fitSession(measurement);
  const std::vector<Closure> closures = closuresOf(measurement);
  ASSERT_EQ(closures.size(), 2u);
  EXPECT_EQ(nameOf(closures[0].of), "radius");
  EXPECT_NEAR(closures[0].value, 0.3, 1e-8);
  EXPECT_NEAR(closures[0].sigma, std::hypot(fit.sigmas[0].radius, fit.sigmas[1].radius), 1e-10);
  EXPECT_EQ(nameOf(closures[1].of), "centre");
  EXPECT_NEAR(closures[1].value, -0.4, 1e-8);
  EXPECT_NEAR(closures[1].sigma, std::hypot(fit.sigmas[0].x, fit.sigmas[1].x), 1e-10);
}

// A zero error of its σ moves its centre by L times that. An error of L is common to both radii, and would be
// 0.166 mm in each for 1 mm of L.
TEST(Closures, CarryTheZerosAndNotTheDistance) {
  Measurement measurement = withArcs({0, 1, 400}, {0, -1, 400});
  const double of = closuresOf(measurement)[0].sigma, ofCentre = closuresOf(measurement)[1].sigma;
  measurement.sigmaZeroHorizontal = Angle::fromArcseconds(10);
  measurement.sigmaDistance = 1;
  const std::vector<Closure> closures = closuresOf(measurement);
  EXPECT_NEAR(closures[0].sigma, of, 0.02 * of);
  const double ofZeros = std::sqrt(2) * 2405 * Angle::fromArcseconds(10).radians();
  EXPECT_NEAR(closures[1].sigma, std::hypot(ofCentre, ofZeros), 0.03 * ofZeros);  // the points of the arc are
                                                                                  // 400 mm from its centre
}

// A repeated position with a zero off by (h, v) is L h to the side and L v higher, with the same radius.
TEST(Closures, TellWhatRepeatsDisagreeBy) {
  Measurement measurement = withArcs({0, 1, 400}, {0, -1, 400});
  std::ranges::reverse(measurement.arcs);
  measurement.arcs.push_back(test::perfectArc(measurement, {0.5, 0.2, 400.4}, test::spread(9, 120)));
  measurement.arcs.back().repeat = 2;
  measurement.arcs.back().position = 2;
  const SessionFit fit = fitSession(measurement);
  std::vector<Circle> starts;
  for (const ArcFit& arc : fit.arcs) starts.push_back(arc.circle);
  const auto apart = fitApart(measurement, starts, {});
  ASSERT_TRUE(apart);
  const std::vector<Closure> repeats = repeatsOf(measurement, *apart);
  ASSERT_EQ(repeats.size(), 3u);
  const double expected[] = {0.5, -0.8, 0.4};
  const Unknown::Kind quantities[] = {Unknown::Kind::CentreX, Unknown::Kind::CentreY, Unknown::Kind::Radius};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(nameOf(repeats[i].of), "repeat");
    EXPECT_EQ(repeats[i].repeated, (Closure::Repeated{0, 2, quantities[i]}));
    EXPECT_NEAR(repeats[i].value, expected[i], 1e-7);
    EXPECT_TRUE(fails(repeats[i]));
  }
  measurement.radiusModel = RadiusModel::Common;
  EXPECT_EQ(repeatsOf(measurement, *fitApart(measurement, starts, {})).size(), 2u);
  measurement.arcs.pop_back();
  starts.pop_back();
  EXPECT_FALSE(fitApart(measurement, starts, {}));
}

TEST(Closures, NeedBothPositionsAndWhatIsFreeInEach) {
  Measurement measurement = withArcs({0, 1, 400}, {0, -1, 400});
  measurement.radiusModel = RadiusModel::Common;
  ASSERT_EQ(closuresOf(measurement).size(), 1u);
  EXPECT_EQ(closuresOf(measurement)[0].of, Closure::Of::Centre);
  measurement.arcs.pop_back();
  EXPECT_TRUE(closuresOf(measurement).empty());
}

// The chance of sound sessions is uniform over 0…1, for any number of points. The mean of 400 is 1/2 within
// four times 0.29/√400. One in a thousand fails, so more than four of them are very improbable.
TEST(Closures, FailByChanceAsOftenAsTheySay) {
  std::mt19937_64 generator(20261123);
  double sum = 0;
  int count = 0, failed = 0;
  for (int i = 0; i < 200; ++i) {
    Measurement measurement = withArcs({0, 1, 400}, {0, -1, 400}, 5 + i % 20);
    for (ArcMeasurement& arc : measurement.arcs) test::addNoise(arc, measurement, generator);
    for (const Closure& closure : closuresOf(measurement)) {
      sum += closure.chance;
      failed += fails(closure) ? 1 : 0;
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0.5, 4 * 0.29 / std::sqrt(count));
  EXPECT_LE(failed, 4);
}

// Radii 401.954 and 403.914 mm, Δx −0.834 and −1.483 mm.
TEST(Closures, OfThePapersReadingsFail) {
  const std::vector<Closure> closures = closuresOf(test::paperMeasurement());
  ASSERT_EQ(closures.size(), 2u);
  EXPECT_NEAR(closures[0].value, 1.959, 0.001);
  EXPECT_NEAR(closures[1].value, -0.648, 0.001);
  for (const Closure& closure : closures) EXPECT_TRUE(fails(closure));
}

}  // namespace
}  // namespace alidade
