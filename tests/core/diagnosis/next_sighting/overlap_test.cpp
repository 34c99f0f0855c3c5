#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/diagnosis/next_sighting/weighed.h"

namespace alidade {
namespace {

double density(double x, double mean, double variance) {
  return std::exp(-(x - mean) * (x - mean) / (2 * variance)) / std::sqrt(2 * std::numbers::pi * variance);
}

/// ∫ √(p q) by the trapezoidal rule.
double integrated(double mean, double variance, double otherMean, double otherVariance) {
  constexpr double step = 1e-3, range = 60;
  double sum = 0;
  for (double x = -range; x <= range; x += step)
    sum += std::sqrt(density(x, mean, variance) * density(x, otherMean, otherVariance)) * step;
  return sum;
}

Prediction of(double mean, double variance) {
  return {Eigen::VectorXd::Constant(1, mean), Eigen::MatrixXd::Constant(1, 1, variance)};
}

TEST(Overlap, IsTheIntegralOfTheRootOfBothDensities) {
  EXPECT_NEAR(overlapOf(of(0, 1), of(0, 1)), 1, 1e-12);
  EXPECT_NEAR(overlapOf(of(0, 1), of(2, 1)), integrated(0, 1, 2, 1), 1e-6);
  EXPECT_NEAR(overlapOf(of(1, 1), of(-2, 9)), integrated(1, 1, -2, 9), 1e-6);
}

TEST(Overlap, IsTheProductOfThoseOfIndependentReadings) {
  Prediction one{Eigen::Vector2d(0, 3), Eigen::Vector2d(1, 2).asDiagonal()};
  Prediction other{Eigen::Vector2d(1, -1), Eigen::Vector2d(4, 2).asDiagonal()};
  EXPECT_NEAR(overlapOf(one, other), integrated(0, 1, 1, 4) * integrated(3, 2, -1, 2), 1e-6);
}

}  // namespace
}  // namespace alidade
