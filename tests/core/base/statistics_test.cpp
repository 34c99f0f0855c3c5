#include "core/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

// With two degrees of freedom the tail is exp(−χ²/2).
TEST(Statistics, ChiSquareTailMeetsItsClosedForm) {
  for (const double chiSquare : {0.0, 0.5, 3.0, 40.0, 900.0})
    EXPECT_NEAR(chiSquareUpperTail(chiSquare, 2) / std::exp(-chiSquare / 2), 1, 1e-12) << chiSquare;
}

// With an even f the tail is a sum of Poisson's terms, exp(−x/2) Σ (x/2)^k/k! for k < f/2; for many degrees
// of freedom it is normal after Wilson and Hilferty, to 1e-4 at f = 10⁵. What a plan without noise leaves is
// all but nothing.
TEST(Statistics, ChiSquareTailStandsForManyDegreesOfFreedom) {
  for (const double f : {2000.0, 3600.0, 1e5, 1e7})
    for (const double chiSquare : {0.0, 1e-300, 1e-20, 1.0, f / 10, f / 2})
      EXPECT_EQ(chiSquareUpperTail(chiSquare, f), 1) << chiSquare << " with " << f;
  for (const double z : {-3.0, -1.0, 0.0, 2.0, 4.0}) {
    const double f = 1e5, ofCubeRoot = 2 / (9 * f);
    const double chiSquare = f * std::pow(1 - ofCubeRoot + z * std::sqrt(ofCubeRoot), 3);
    EXPECT_NEAR(chiSquareUpperTail(chiSquare, f), std::erfc(z / std::sqrt(2.0)) / 2, 1e-4) << z;
  }
  for (const double chiSquare : {1.0, 5.0, 12.0, 18.0, 22.0, 40.0}) {  // on both sides of the short cut
    double term = std::exp(-chiSquare / 2), sum = 0;
    for (int k = 0; k < 20; ++k, term *= chiSquare / 2 / k) sum += term;
    EXPECT_NEAR(chiSquareUpperTail(chiSquare, 40), sum, 1e-14) << chiSquare;
  }
}

// F with two numerator degrees has the closed form (1 + 2F/n)^(−n/2); with infinitely many in the
// denominator it is χ²/2.
TEST(Statistics, GivesTheUpperTailOfF) {
  for (const double ratio : {0.0, 0.3, 1.0, 4.0, 20.0}) {
    for (const double n : {1.0, 5.0, 28.0})
      EXPECT_NEAR(fUpperTail(ratio, 2, n) / std::pow(1 + 2 * ratio / n, -n / 2), 1, 1e-12);
    EXPECT_NEAR(fUpperTail(ratio, 2, std::numeric_limits<double>::infinity()) / std::exp(-ratio), 1, 1e-12);
  }
}

}  // namespace
}  // namespace alidade
