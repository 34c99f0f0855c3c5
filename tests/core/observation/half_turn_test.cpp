#include "core/observation/half_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace alidade {
namespace {

// The reference is the rotation itself, by `axisDeg` about x.
TEST(HalfTurn, SignIsThatOfARotationAboutX) {
  for (const int axisDeg : {0, 180}) {
    const double angle = axisDeg * std::numbers::pi / 180;
    const double y = 3, z = 5;
    EXPECT_NEAR(halfTurnSign(axisDeg) * y, y * std::cos(angle) - z * std::sin(angle), 1e-15);
    EXPECT_NEAR(halfTurnSign(axisDeg) * z, y * std::sin(angle) + z * std::cos(angle), 1e-15);
  }
}

// A mark of the scale is at s in the plane of the guideway; with the guideway turned, it is seen at φ.
TEST(HalfTurn, SliderCoordinateStaysWithTheGuideway) {
  for (const int axisDeg : {0, 180})
    for (const double s : {-2.5, -0.4, 0.0, 1.0, 3.0}) {
      const double angle = axisDeg * std::numbers::pi / 180;
      const double phi = std::atan2(std::sin(s) * std::cos(angle), std::cos(s));
      EXPECT_NEAR(arcAngleOf(s, axisDeg), phi, 1e-15);
      EXPECT_EQ(sliderCoordinateOf(arcAngleOf(s, axisDeg), axisDeg), s);
    }
}

// Centres at Δd above the axis at 0° and below it at 180°.
TEST(HalfTurn, HeightsOfBothCentresMakeTheIntersection) {
  const double axis = 7, intersection = 1.25;
  EXPECT_EQ(
      intersectionPerHeight(0) * (axis + intersection) + intersectionPerHeight(180) * (axis - intersection),
      intersection);
}

}  // namespace
}  // namespace alidade
