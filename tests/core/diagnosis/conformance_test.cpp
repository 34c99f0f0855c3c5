#include "core/diagnosis/conformance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alidade {
namespace {

IntersectionEstimate normal(double value, double sigma) {
  return {
      value, sigma, 1.959963984540054 * sigma, {{1, value, sigma}}, std::numeric_limits<double>::infinity()};
}

// From the normal distribution: Φ(2) − Φ(−6) for 1 ± 0.5 (1σ) within ± 2.
TEST(Conformance, OfTheIntersectionIsTheShareWithinTheTolerance) {
  EXPECT_NEAR(*conformanceOf(normal(1, 0.5), 2), 0.9772498671, 1e-9);
  EXPECT_NEAR(*conformanceOf(normal(-1, 0.5), 2), 0.9772498671, 1e-9);
}

// The shares of the accounts have an arbitrary sum; the quotient must not exceed 1 by rounding.
TEST(Conformance, IsAtMostCertain) {
  IntersectionEstimate estimate = normal(0, 1e-6);
  estimate.explanations.clear();
  for (int i = 1; i < 200; ++i) {
    estimate.explanations.push_back({1.0 / (3 * i), 0, 1e-6});
    EXPECT_LE(*conformanceOf(estimate, 1e3), 1) << i;
  }
}

TEST(Conformance, IsAbsentWithoutAnUncertainty) {
  EXPECT_EQ(conformanceOf(normal(1, 0), 1), std::nullopt);
  EXPECT_EQ(conformanceOf(IntersectionEstimate{1, 0.1, 0.2}, 2), std::nullopt);
}

// Both components are zero with equal σ: Rayleigh's distribution, 1 − exp(−T²/2σ²).
TEST(Conformance, OfTheDistanceIsRayleighs) {
  for (const double tolerance : {0.2, 0.5, 1.0})
    EXPECT_NEAR(*conformanceOf(normal(0, 0.4), {0, 0.4, 0.8}, tolerance),
                1 - std::exp(-tolerance * tolerance / (2 * 0.16)), 1e-3);
}

// An exactly known offset z across the plane leaves √(T² − z²) for the component in the plane.
TEST(Conformance, OfTheDistanceKnowsASurePart) {
  EXPECT_NEAR(*conformanceOf(normal(0.5, 0.3), {3, 1e-9, 2e-9}, 5), *conformanceOf(normal(0.5, 0.3), 4),
              1e-6);
  EXPECT_EQ(*conformanceOf(normal(0.5, 0.3), {6, 1e-9, 2e-9}, 5), 0);
}

// For a normal distribution 2.5 % are beyond each end of U at 95 %, and 5 % beyond both if these are the
// tolerance limits. Student's distribution with one degree of freedom has half of its probability beyond ±1.
TEST(GreatestRisk, IsThatAtTheEdgesOfTheGuardBand) {
  constexpr double rounding = 1e-5;
  IntersectionEstimate estimate = normal(1.7, 0.3 / 1.959963984540054);
  EXPECT_NEAR(*greatestRisk(estimate, 2.5), 0.025, rounding);
  EXPECT_NEAR(*greatestRisk(estimate, 0.3), 0.05, rounding);
  EXPECT_NEAR(*greatestRisk(estimate, 0.2), 0.025, rounding) << "nothing is accepted, too much rejected";
  estimate.expanded = 0;
  EXPECT_NEAR(*greatestRisk(estimate, 2.5), 0.5, rounding) << "no guard";
  estimate = {.value = 0, .sigma = 1, .expanded = 1, .explanations = {{1, 0, 1}}, .degreesOfFreedom = 1};
  EXPECT_NEAR(*greatestRisk(estimate, 1e6), 0.25, rounding);
  estimate.degreesOfFreedom = 0;
  EXPECT_FALSE(greatestRisk(estimate, 2.5));
}

// One account in twenty exceeds the others by more than U, none is below. For acceptance at the upper limit
// all of it is beyond the tolerance.
TEST(GreatestRisk, IsThatOfTheHeavierSide) {
  const IntersectionEstimate estimate{.value = 0,
                                      .sigma = 0.5,
                                      .expanded = 1,
                                      .explanations = {{19, 0, 0.01}, {1, 2, 0.01}},
                                      .degreesOfFreedom = std::numeric_limits<double>::infinity()};
  EXPECT_NEAR(*greatestRisk(estimate, 10), 0.05, 1e-9);
}

}  // namespace
}  // namespace alidade
