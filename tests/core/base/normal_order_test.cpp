#include "core/base/normal_order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace alidade::test {
namespace {

double normalTail(double z) {
  return std::erfc(z / std::sqrt(2)) / 2;
}

// The expected order statistics of ten normal values (Harter 1961), which Blom's scores approximate.
TEST(NormalOrder, ScoresAreCloseToTheExpectedValues) {
  const double expected[] = {-1.53875, -1.00136, -0.65606, -0.37576, -0.12267};
  for (std::size_t i = 0; i < 5; ++i) {
    const auto rank = static_cast<double>(i + 1);
    EXPECT_NEAR(normalScore(rank, 10), expected[i], 0.01);
    EXPECT_NEAR(normalScore(11 - rank, 10), -expected[i], 0.01);
  }
  EXPECT_DOUBLE_EQ(normalScore(1, 1), 0);
}

// The largest of n is below z with probability Φ(z)ⁿ, the smallest above it with (1 − Φ(z))ⁿ.
TEST(NormalOrder, QuantilesOfTheExtremesAreThoseOfPowers) {
  for (const std::size_t count : {1U, 2U, 34U, 20000U})
    for (const double probability : {0.025, 0.5, 0.975}) {
      const double n = static_cast<double>(count);
      const double greatest = normalOrderQuantile(probability, n, count);
      EXPECT_NEAR(std::pow(1 - normalTail(greatest), n), probability, 1e-9) << count;
      const double least = normalOrderQuantile(probability, 1, count);
      EXPECT_NEAR(std::pow(normalTail(least), n), 1 - probability, 1e-9) << count;
    }
}

// Φ of the middle one of three normal values has the distribution function 3p² − 2p³.
TEST(NormalOrder, QuantilesOfTheMedianOfThree) {
  for (const double probability : {0.025, 0.3, 0.975}) {
    const double p = 1 - normalTail(normalOrderQuantile(probability, 2, 3));
    EXPECT_NEAR(3 * p * p - 2 * p * p * p, probability, 1e-12);
  }
}

}  // namespace
}  // namespace alidade::test
