#include "core/adjustment/numerics/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace alidade {
namespace {

/// One unknown x, residuals v(x) in σ with derivative v'(x), and one that x does not change; no x below
/// `wall`.
struct OneUnknown {
  using State = double;
  struct System {
    double normal = 0, right = 0, chiSquare = 0;
  };

  std::function<double(double)> residual, derivative;
  double wall = -std::numeric_limits<double>::infinity(), constant = 0;
  mutable int evaluated = 0;

  System system(double x, const System& /*used*/) const {
    ++evaluated;
    const double v = residual(x), d = derivative(x);
    return {d * d, -d * v, v * v + constant * constant};
  }
  double remaining(const System& system) const { return std::abs(system.right) / std::sqrt(system.normal); }
  double moved(double x, const System& system, double damping) const {
    return x + system.right / (system.normal * (1 + damping));
  }
  bool isPossible(double x) const { return x > wall; }
};

/// v = (x − 2)/σ, σ = ½.
OneUnknown line() {
  return {.residual = [](double x) { return 2 * (x - 2); }, .derivative = [](double) { return 2; }};
}

/// v = x² − 9.
OneUnknown parabola() {
  return {.residual = [](double x) { return x * x - 9; }, .derivative = [](double x) { return 2 * x; }};
}

// With the damping d, each step of a linear problem leaves d/(1 + d) of the way: 1e-3 of it, then 1e-4, ….
TEST(LeastSquares, TakesTheDampedStepsOfALine) {
  const OneUnknown problem = line();
  const auto one = minimise(problem, 12.0, {.maximumIterations = 1, .tolerance = 0, .firstDamping = 1e-3});
  EXPECT_NEAR(one.state, 2 + 10 * 1e-3 / 1.001, 1e-12);
  const auto two = minimise(problem, 12.0, {.maximumIterations = 2, .tolerance = 0, .firstDamping = 1e-3});
  EXPECT_NEAR(two.state, 2 + 10 * 1e-3 / 1.001 * 1e-4 / 1.0001, 1e-12);
  EXPECT_EQ(two.iterations, 2);
}

// λ is the distance to the minimum in σ: |x − 2|/½.
TEST(LeastSquares, ConvergesWhereTheMinimumIsNearerThanTheTolerance) {
  const OneUnknown problem = line();
  const auto there = minimise(problem, 2.0004, {.tolerance = 1e-3});
  EXPECT_EQ(there.status, FitStatus::Converged);
  EXPECT_EQ(there.iterations, 0);
  EXPECT_EQ(there.state, 2.0004);
  const auto onItsWay = minimise(problem, 2.0006, {.tolerance = 1e-3});
  EXPECT_EQ(onItsWay.status, FitStatus::Converged);
  EXPECT_EQ(onItsWay.iterations, 1);
}

TEST(LeastSquares, FindsTheRootOfACurve) {
  const auto found = minimise(parabola(), 1.0, {.tolerance = 1e-12});
  EXPECT_EQ(found.status, FitStatus::Converged);
  EXPECT_NEAR(found.state, 3, 1e-13);
  EXPECT_NEAR(found.system.chiSquare, 0, 1e-20);
}

// From a start at the minimum the iteration ends only after one step and a second one that confirms it,
// unless the start leaves next to no residuals.
TEST(LeastSquares, DoesNotTrustASmallStepThatNeedsConfirmation) {
  OneUnknown problem = line();
  EXPECT_EQ(minimise(problem, 2.0, {.tolerance = 1e-6, .confirmation = 1e-4}).iterations, 0);
  problem.constant = 1;
  const auto found = minimise(problem, 2.0, {.tolerance = 1e-6, .confirmation = 1e-4});
  EXPECT_EQ(found.status, FitStatus::Converged);
  EXPECT_EQ(found.iterations, 2);
  // From afar the first step leaves less than the tolerance, but the step before it was not small.
  const auto fromAfar =
      minimise(problem, 12.0, {.tolerance = 1e-3, .confirmation = 1e-2, .firstDamping = 1e-6});
  EXPECT_EQ(fromAfar.iterations, 2);
}

TEST(LeastSquares, SaysThatItWasStillOnItsWay) {
  const auto found = minimise(parabola(), 100.0, {.maximumIterations = 3});
  EXPECT_EQ(found.status, FitStatus::TooManyIterations);
  EXPECT_EQ(found.iterations, 3);
  EXPECT_GT(found.state, 3);
  EXPECT_EQ(minimise(parabola(), 100.0, {.maximumIterations = 0}).state, 100);
}

// With a derivative of the wrong sign every step, however short, leads uphill.
TEST(LeastSquares, SaysThatNoStepLowersChiSquare) {
  OneUnknown problem = line();
  problem.derivative = [](double) { return -2; };
  const auto found = minimise(problem, 12.0, {.firstDamping = 1e-3, .largestDamping = 1e3});
  EXPECT_EQ(found.status, FitStatus::NoDescent);
  EXPECT_EQ(found.state, 12);
  EXPECT_EQ(found.iterations, 6);  // one for each damping from 1e-3 to 1e2
}

// The other root of the parabola is beyond the wall, and the undamped step would lead there.
TEST(LeastSquares, StopsShortOfAWall) {
  OneUnknown problem = parabola();
  problem.wall = 0;
  EXPECT_LT(problem.moved(0.1, problem.system(-0.1, {}), 0), 0);
  const auto found = minimise(problem, 0.1, {.tolerance = 1e-12});
  EXPECT_NEAR(found.state, 3, 1e-12);
  // If the minimum itself is beyond it, the steps approach as far as damping allows and end there.
  OneUnknown beyond = line();
  beyond.wall = 5;
  beyond.evaluated = 0;
  const auto atTheWall = minimise(beyond, 12.0, {.largestDamping = 1e6});
  EXPECT_EQ(atTheWall.status, FitStatus::NoDescent);
  EXPECT_GT(atTheWall.state, 5);
  EXPECT_LT(atTheWall.state, 6);
  EXPECT_LT(beyond.evaluated, atTheWall.iterations);  // nothing is evaluated beyond the wall
}

// v = 1/x decreases for ever: x doubles at each step, and the remaining way never becomes short.
TEST(LeastSquares, DoesNotCallARunawayConverged) {
  const OneUnknown problem{.residual = [](double x) { return 1 / x; },
                           .derivative = [](double x) { return -1 / (x * x); }};
  const auto found = minimise(problem, 1.0, {.maximumIterations = 20, .tolerance = 1e-9});
  EXPECT_EQ(found.status, FitStatus::TooManyIterations);
  EXPECT_NEAR(found.state, std::pow(2.0, 20), 10);
}

TEST(LeastSquares, NoNumbersAreNoDescent) {
  const OneUnknown problem{.residual = [](double) { return std::nan(""); },
                           .derivative = [](double) { return 1; }};
  EXPECT_EQ(minimise(problem, 1.0, {}).status, FitStatus::NoDescent);
}

TEST(LeastSquares, TellsARiseFromRounding) {
  EXPECT_FALSE(isRise(100, 100));
  EXPECT_FALSE(isRise(100, 100 + 1e-8));
  EXPECT_TRUE(isRise(100, 100 + 1e-6));
  EXPECT_FALSE(isRise(0, 1e-10));
  EXPECT_TRUE(isRise(0, 1e-8));
  EXPECT_TRUE(isRise(100, std::nan("")));
}

}  // namespace
}  // namespace alidade
