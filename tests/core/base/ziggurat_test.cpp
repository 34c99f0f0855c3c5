#include "core/base/ziggurat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace alidade {
namespace {

constexpr int count = 2'000'000;

/// The share of numbers with a larger |z|.
double shareBeyond(double z) {
  return std::erfc(z / std::numbers::sqrt2);
}

// A share p of n numbers is beyond each bound, ± √(np(1 − p)); five times that occurs once in two million.
// 3.6542 is the start of the tail, which is drawn by another method.
TEST(Ziggurat, HasTheTailsOfTheNormalDistribution) {
  constexpr std::array bounds{0.1, 0.5, 1.0, 2.0, 3.0, 3.5, 3.6541, 3.6543, 4.0, 4.5};
  std::array<int, bounds.size()> above{}, below{};
  RandomSource random(11);
  for (int i = 0; i < count; ++i) {
    const double z = zigguratNormal(random);
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      above[b] += z > bounds[b] ? 1 : 0;
      below[b] += z < -bounds[b] ? 1 : 0;
    }
  }
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    const double expected = count * shareBeyond(bounds[b]) / 2, scatter = 5 * std::sqrt(expected) + 1;
    EXPECT_NEAR(above[b], expected, scatter) << bounds[b];
    EXPECT_NEAR(below[b], expected, scatter) << bounds[b];
  }
}

// χ² over 200 equally probable intervals: it detects a layer that is too wide or too narrow.
TEST(Ziggurat, FillsEveryStretchAlike) {
  constexpr int stretches = 200;
  std::array<int, stretches> found{};
  RandomSource random(12);
  for (int i = 0; i < count; ++i) {
    const double below = 0.5 * std::erfc(-zigguratNormal(random) / std::numbers::sqrt2);
    ++found[static_cast<std::size_t>(std::min(stretches - 1.0, below * stretches))];
  }
  double chiSquare = 0;
  constexpr double expected = static_cast<double>(count) / stretches;
  for (const int number : found) chiSquare += (number - expected) * (number - expected) / expected;
  EXPECT_GT(chiSquare, 120);  // of χ² with 199 degrees of freedom below 120 or above 300: once in 10⁵ times
  EXPECT_LT(chiSquare, 300);
}

TEST(Ziggurat, HasNoCorrelationFromOneNumberToTheNext) {
  RandomSource random(13);
  double sum = 0, previous = zigguratNormal(random), fourth = 0;
  for (int i = 0; i < count; ++i) {
    const double z = zigguratNormal(random);
    sum += z * previous;
    fourth += z * z * z * z;
    previous = z;
  }
  EXPECT_NEAR(sum / count, 0, 5 / std::sqrt(count));
  EXPECT_NEAR(fourth / count, 3, 5 * std::sqrt(96.0 / count));
}

TEST(Ziggurat, FillsWithTheNumbersThatItDrawsOneByOne) {
  RandomSource single(5, 2), together(5, 2);
  std::array<double, 3000> values{};  // some thirty of them take more than one number of the source
  fillWithNormals(together, values);
  for (const double value : values) ASSERT_EQ(value, zigguratNormal(single));
  EXPECT_EQ(together.bits(), single.bits()) << "the source goes on where it stands";
}

}  // namespace
}  // namespace alidade
