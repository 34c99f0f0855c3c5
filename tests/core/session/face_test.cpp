#include "core/session/face.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

Angle degrees(double value) {
  return Angle::fromDegrees(value);
}

// A target 5° above the horizon at direction 30°: face 2 of a zenith circle reads 210° and 275°, of an
// elevation circle 210° and 175°.
TEST(Face, FaceTwoReadsTheSameTarget) {
  const FaceOneReading zenith = inFaceOne(degrees(210), degrees(275), 2, VerticalCircle::Zenith);
  EXPECT_NEAR(zenith.horizontal.degrees(), 30, 1e-12);
  EXPECT_NEAR(zenith.vertical.degrees(), 85, 1e-12);
  const FaceOneReading elevation = inFaceOne(degrees(210), degrees(175), 2, VerticalCircle::Elevation);
  EXPECT_NEAR(elevation.vertical.degrees(), 5, 1e-12);
  EXPECT_EQ(inFaceOne(degrees(30), degrees(85), 1, VerticalCircle::Zenith).vertical.degrees(), 85);
}

TEST(Face, TellsFacesByTheVerticalCircle) {
  EXPECT_FALSE(isFaceTwo(degrees(85), VerticalCircle::Zenith));
  EXPECT_TRUE(isFaceTwo(degrees(275), VerticalCircle::Zenith));
  EXPECT_FALSE(isFaceTwo(degrees(5), VerticalCircle::Elevation));
  EXPECT_FALSE(isFaceTwo(degrees(-5), VerticalCircle::Elevation));
  EXPECT_FALSE(isFaceTwo(degrees(355), VerticalCircle::Elevation));
  EXPECT_TRUE(isFaceTwo(degrees(175), VerticalCircle::Elevation));
}

}  // namespace
}  // namespace alidade::test
