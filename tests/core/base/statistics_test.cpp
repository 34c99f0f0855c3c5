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
