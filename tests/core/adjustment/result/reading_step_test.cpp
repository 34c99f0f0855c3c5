#include "core/adjustment/result/reading_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace alidade {
namespace {

std::vector<Angle> multiplesOf(double step, int count, double first = 0) {
  std::mt19937_64 random(7);
  std::vector<Angle> readings;
  for (int i = 0; i < count; ++i)
    readings.push_back(Angle::fromArcseconds(first + step * static_cast<double>(random() % 5000)));
  return readings;
}

// The step is independent of the origin of the readings, also across 360°.
TEST(ReadingStep, IsTheCoarsestThatDividesAllDifferences) {
  for (const double step : {3600.0, 324.0, 60.0, 32.4, 30.0, 10.0, 3.6}) {
    const auto found = readingStep(multiplesOf(step, 40, 12.3), Angle::fromArcseconds(1));
    ASSERT_TRUE(found) << step;
    EXPECT_NEAR(found->arcseconds(), step, 1e-9);
  }
}

TEST(ReadingStep, IsAbsentWhereReadingsAreFinerOrFew) {
  std::vector<Angle> readings = multiplesOf(60, 40);
  EXPECT_FALSE(readingStep(readings, Angle::fromArcseconds(60))) << "no coarser than asked";
  readings.push_back(Angle::fromArcseconds(7.31));
  EXPECT_FALSE(readingStep(readings, Angle::fromArcseconds(1)));
  EXPECT_FALSE(readingStep(multiplesOf(60, 5), Angle::fromArcseconds(1)));
  EXPECT_FALSE(readingStep(std::vector(20, Angle::fromDegrees(3)), Angle::fromArcseconds(1)))
      << "all the same";
  EXPECT_FALSE(readingStep({}, Angle::fromArcseconds(1)));
}

// A million roundings to 60″: 17.32″ ± 0.01″.
TEST(ReadingStep, ScattersAsAUniformDistribution) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> reading(0, 1e5);
  double sum = 0;
  constexpr int count = 1'000'000;
  for (int i = 0; i < count; ++i) {
    const double exact = reading(random);
    sum += std::pow(std::round(exact / 60) * 60 - exact, 2);
  }
  EXPECT_NEAR(roundingSigma(Angle::fromArcseconds(60)).arcseconds(), std::sqrt(sum / count), 0.05);
}

}  // namespace
}  // namespace alidade
