#include "core/adjustment/numerics/arc_angle_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace alidade {
namespace {

TEST(ArcAngleStep, LetsThroughWhatIsShort) {
  for (const double step : {-0.29, -1e-9, 0.0, 1e-14, 0.29}) EXPECT_EQ(boundedArcAngleStep(step), step);
  EXPECT_EQ(boundedArcAngleStep(1e6), longestArcAngleStep);
  EXPECT_EQ(boundedArcAngleStep(-1e6), -longestArcAngleStep);
}

// The step of a point `distance` radii from the centre, θ away from its foot, is distance · sin θ exactly.
TEST(ArcAngleStep, LeadsToTheFootTheShortWay) {
  for (const double distance : {1.0, 1.3, 1.6})
    for (double theta = -3.1; theta < 3.15; theta += 0.2) {
      double left = theta;
      for (int i = 0; i < 25; ++i) {
        left -= boundedArcAngleStep(distance * std::sin(left));
        EXPECT_LE(std::abs(left), std::numbers::pi) << "over the far side from " << theta;
      }
      EXPECT_NEAR(left, 0, 1e-3) << "from " << theta << " at " << distance;
    }
}

// From ten radii away the whole step would lead anywhere; the bounded one ends within a step of the foot.
TEST(ArcAngleStep, KeepsAPoorStartOnItsSide) {
  for (const double theta : {-2.0, -1.0, 1.0, 2.0}) {
    double left = theta;
    for (int i = 0; i < 25; ++i) {
      left -= boundedArcAngleStep(10 * std::sin(left));
      EXPECT_LE(std::abs(left), std::abs(theta)) << "from " << theta;
    }
    EXPECT_LE(std::abs(left), longestArcAngleStep);
  }
}

// 1 − cos of the bound, as stated in its comment.
TEST(ArcAngleStep, TangentIsStillNearTheArcThere) {
  EXPECT_NEAR(1 - std::cos(longestArcAngleStep), 0.045, 0.0005);
  EXPECT_EQ(std::ceil(std::numbers::pi / longestArcAngleStep), 11);
}

}  // namespace
}  // namespace alidade
