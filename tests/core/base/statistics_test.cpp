#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace alidade {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Printed tables (GUM, table G.2) give the quantiles to two decimals.
TEST(Statistics, CoverageFactorMeetsTheTableOfTheGum) {
  EXPECT_NEAR(coverageFactor(0.95, 1), 12.71, 0.005);
  EXPECT_NEAR(coverageFactor(0.95, 10), 2.23, 0.005);
  EXPECT_NEAR(coverageFactor(0.9545, 50), 2.05, 0.005);
  EXPECT_NEAR(coverageFactor(0.95, infinite), 1.960, 0.0005);
  EXPECT_NEAR(coverageFactor(0.9973, infinite), 3.000, 0.0005);
}

// The C library's erfc, to its rounding times the condition number z² of a tail.
TEST(Statistics, NormalQuantileTurnsTheErrorFunctionRound) {
  for (double p = 0.95; p > 1e-300; p *= 0.7)
    EXPECT_NEAR(std::erfc(-normalQuantile(p) / std::numbers::sqrt2) / 2, p, 1e-12 * p) << p;
}

// With two degrees of freedom the tail is exp(−χ²/2).
TEST(Statistics, ChiSquareTailMeetsItsClosedForm) {
  for (const double chiSquare : {0.0, 0.5, 3.0, 40.0, 900.0})
    EXPECT_NEAR(chiSquareUpperTail(chiSquare, 2).value() / std::exp(-chiSquare / 2), 1, 1e-12) << chiSquare;
}

// With an even f the tail is a sum of Poisson's terms, exp(−x/2) Σ (x/2)^k/k! for k < f/2; for many degrees
// of freedom it is normal after Wilson and Hilferty, to 1e-4 at f = 10⁵. A plan without noise has almost zero
// χ².
TEST(Statistics, ChiSquareTailStandsForManyDegreesOfFreedom) {
  for (const double f : {2000.0, 3600.0, 1e5, 1e7})
    for (const double chiSquare : {0.0, 1e-300, 1e-20, 1.0, f / 10, f / 2})
      EXPECT_EQ(chiSquareUpperTail(chiSquare, f).value(), 1) << chiSquare << " with " << f;
  for (const double z : {-3.0, -1.0, 0.0, 2.0, 4.0}) {
    const double f = 1e5, ofCubeRoot = 2 / (9 * f);
    const double chiSquare = f * std::pow(1 - ofCubeRoot + z * std::sqrt(ofCubeRoot), 3);
    EXPECT_NEAR(chiSquareUpperTail(chiSquare, f).value(), std::erfc(z / std::sqrt(2.0)) / 2, 1e-4) << z;
  }
  for (const double chiSquare : {1.0, 5.0, 12.0, 18.0, 22.0, 40.0}) {  // on both sides of the short cut
    double term = std::exp(-chiSquare / 2), sum = 0;
    for (int k = 0; k < 20; ++k, term *= chiSquare / 2 / k) sum += term;
    EXPECT_NEAR(chiSquareUpperTail(chiSquare, 40).value(), sum, 1e-14) << chiSquare;
  }
}

// F with two numerator degrees has the closed form (1 + 2F/n)^(−n/2); with an infinite denominator it is
// χ²/2.
TEST(Statistics, GivesTheUpperTailOfF) {
  for (const double ratio : {0.0, 0.3, 1.0, 4.0, 20.0}) {
    for (const double n : {1.0, 5.0, 28.0})
      EXPECT_NEAR(fUpperTail(2 * ratio, 2, n).value() / std::pow(1 + 2 * ratio / n, -n / 2), 1, 1e-12);
    EXPECT_NEAR(fUpperTail(2 * ratio, 2, infinite).value() / std::exp(-ratio), 1, 1e-12);
  }
}

TEST(Statistics, TakesRoundingBelowZeroForZeroAndWhatIsNoSquareForUnknown) {
  EXPECT_EQ(WeightedSquareSum(-1e-9).value(), 0);
  EXPECT_EQ(WeightedSquareSum(7).value(), 7);
  EXPECT_TRUE(WeightedSquareSum(infinite).isKnown());
  EXPECT_FALSE(WeightedSquareSum(-0.01).isKnown());
  EXPECT_FALSE(WeightedSquareSum(std::nan("")).isKnown());
  EXPECT_EQ(standardDeviation(-1e-9), 0);
  EXPECT_EQ(standardDeviation(9), 3);
  EXPECT_TRUE(std::isnan(standardDeviation(std::nan(""))));
}

TEST(Statistics, HasDegreesOfFreedomOrNone) {
  for (const double none : {0.0, -3.0, std::nan("")}) EXPECT_FALSE(DegreesOfFreedom(none).isPositive());
  EXPECT_EQ(DegreesOfFreedom(14).count(), 14);
  EXPECT_TRUE(DegreesOfFreedom::infinite().areInfinite());
}

TEST(Statistics, HasNoTailOfTheUnknown) {
  EXPECT_FALSE(chiSquareUpperTail(std::nan(""), 3));
  EXPECT_FALSE(chiSquareUpperTail(-1, 3));
  EXPECT_FALSE(chiSquareUpperTail(5, 0));
  EXPECT_FALSE(chiSquareUpperTail(5, std::nan("")));
  EXPECT_FALSE(fUpperTail(std::nan(""), 1, 4));
  EXPECT_FALSE(fUpperTail(2, 0, 4));
  EXPECT_FALSE(fUpperTail(2, 1, 0));
  EXPECT_EQ(chiSquareUpperTail(infinite, 3), 0);
  EXPECT_EQ(fUpperTail(infinite, 1, 4), 0);
  EXPECT_EQ(chiSquareUpperTail(1e300, 3), 0);
}

// Without degrees of freedom, or beyond the range of doubles, every interval is too narrow; no exception is
// thrown.
TEST(Statistics, HasAnInfiniteFactorWhereNoIntervalIsWideEnough) {
  EXPECT_EQ(coverageFactor(0.95, 0), infinite);
  EXPECT_EQ(coverageFactor(0.95, std::nan("")), infinite);
  EXPECT_GT(coverageFactor(1 - 1e-16, 1), 1e15);
  EXPECT_GT(coverageFactor(0.9999999, 0.05), 1e15);
}

TEST(Statistics, StudentsTailMeetsItsClosedForms) {
  for (const double t : {-40.0, -1.0, 0.0, 0.3, 2.5, 1e6}) {
    EXPECT_NEAR(*studentLowerTail(t, 1), 0.5 + std::atan(t) / std::numbers::pi, 1e-14) << t;
    EXPECT_NEAR(*studentLowerTail(t, 2), 0.5 + t / (2 * std::sqrt(2 + t * t)), 1e-14) << t;
    EXPECT_NEAR(*studentLowerTail(t, infinite), std::erfc(-t / std::sqrt(2)) / 2, 1e-14) << t;
  }
  EXPECT_EQ(studentLowerTail(infinite, 3), 1.0);
  EXPECT_EQ(studentLowerTail(-infinite, 3), 0.0);
  EXPECT_EQ(studentLowerTail(1, 0), std::nullopt);
  EXPECT_EQ(studentLowerTail(std::nan(""), 3), std::nullopt);
}

// JCGM 100, G.4.1: of two parts of equal variance, one known and one with ν degrees of freedom, the sum has
// 4ν. A single part has its own.
TEST(Statistics, GivesTheEffectiveDegreesOfFreedom) {
  EXPECT_NEAR(effectiveDegreesOfFreedom(std::sqrt(2.0), 1, 5).count(), 20, 1e-12);
  EXPECT_NEAR(effectiveDegreesOfFreedom(3, 3, 7).count(), 7, 1e-12);
  EXPECT_TRUE(effectiveDegreesOfFreedom(1, 0, 5).areInfinite());
  EXPECT_TRUE(effectiveDegreesOfFreedom(1, 0.5, infinite).areInfinite());
}

// The middle one of the sorted values, or the mean of the two in the middle, in whatever order they come.
TEST(Statistics, MedianIsInTheMiddleOfTheSortedValues) {
  std::mt19937 random(7);
  for (std::size_t count = 1; count <= 12; ++count) {
    std::vector<double> values(count);
    for (double& value : values) value = static_cast<double>(random() % 9) - 4;
    const double median = medianOf(values);
    std::ranges::sort(values);
    EXPECT_EQ(median, (values[(count - 1) / 2] + values[count / 2]) / 2) << count;
  }
  EXPECT_EQ(medianOf({infinite, 2, -infinite}), 2);
  EXPECT_EQ(medianOf({infinite, 2}), infinite);
}

}  // namespace
}  // namespace alidade
