#include "core/adjustment/numerics/algebraic_circle.h"

#include <gtest/gtest.h>

#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

std::vector<PlanePoint<double>> pointsOf(const Circle& circle, const std::vector<double>& angles) {
  std::vector<PlanePoint<double>> points;
  for (const double phi : angles) points.push_back(targetOnArc(circle.x, circle.y, circle.radius, phi));
  return points;
}

TEST(AlgebraicCircle, FindsTheCircleOfExactPoints) {
  const Circle truth{-35, 60, 400};
  const auto found = algebraicCircle(pointsOf(truth, test::spread(5, 100)));
  ASSERT_TRUE(found);
  // Rounding of squares of 400 mm over a third of a circle.
  EXPECT_NEAR(found->x, truth.x, 1e-9);
  EXPECT_NEAR(found->y, truth.y, 1e-9);
  EXPECT_NEAR(found->radius, truth.radius, 1e-9);
}

TEST(AlgebraicCircle, HasNoAnswerForPointsThatFixNoCircle) {
  EXPECT_FALSE(algebraicCircle({}));
  EXPECT_FALSE(algebraicCircle({{0, 0}, {1, 1}}));
  EXPECT_FALSE(algebraicCircle({{0, 1}, {100, 51}, {200, 101}, {300, 151}}));
  EXPECT_FALSE(algebraicCircle({{7, 7}, {7, 7}, {7, 7}, {7, 7}}));
}

}  // namespace
}  // namespace alidade
