#include "core/diagnosis/conformance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alidade {
namespace {

IntersectionEstimate normal(double value, double sigma) {
  return {value, sigma, 2 * sigma, {{1, value, sigma}}, std::numeric_limits<double>::infinity()};
}

// By the normal distribution: Φ(2) − Φ(−6) of 1 ± 0.5 (1σ) within ± 2.
TEST(Conformance, OfTheIntersectionIsTheShareWithinTheTolerance) {
  EXPECT_NEAR(*conformanceOf(normal(1, 0.5), 2), 0.9772498671, 1e-9);
  EXPECT_NEAR(*conformanceOf(normal(-1, 0.5), 2), 0.9772498671, 1e-9);
}

TEST(Conformance, IsAbsentWithoutAnUncertainty) {
  EXPECT_EQ(conformanceOf(normal(1, 0), 1), std::nullopt);
  EXPECT_EQ(conformanceOf(IntersectionEstimate{1, 0.1, 0.2}, 2), std::nullopt);
}

// Both parts zero and alike: Rayleigh's distribution, 1 − exp(−T²/2σ²).
TEST(Conformance, OfTheDistanceIsRayleighs) {
  for (const double tolerance : {0.2, 0.5, 1.0})
    EXPECT_NEAR(*conformanceOf(normal(0, 0.4), {0, 0.4, 0.8}, tolerance),
                1 - std::exp(-tolerance * tolerance / (2 * 0.16)), 1e-3);
}

// A part across that is sure leaves √(T² − z²) for the one in the plane.
TEST(Conformance, OfTheDistanceKnowsASurePart) {
  EXPECT_NEAR(*conformanceOf(normal(0.5, 0.3), {3, 1e-9, 2e-9}, 5), *conformanceOf(normal(0.5, 0.3), 4),
              1e-6);
  EXPECT_EQ(*conformanceOf(normal(0.5, 0.3), {6, 1e-9, 2e-9}, 5), 0);
}

}  // namespace
}  // namespace alidade
