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

// An elevation circle reads 90° at the zenith, 180° at the horizon behind it and 270° at the nadir: a target
// 5° or 80° below the horizon reads 185° and 260° in face 2, and −80° in face 1.
TEST(Face, TwoOfAnElevationCircleGoesDownToTheNadir) {
  for (const double faceTwo : {95.0, 185.0, 260.0, -100.0})
    EXPECT_TRUE(isFaceTwo(degrees(faceTwo), VerticalCircle::Elevation)) << faceTwo;
  for (const double faceOne : {85.0, 280.0, -80.0})
    EXPECT_FALSE(isFaceTwo(degrees(faceOne), VerticalCircle::Elevation)) << faceOne;
}

}  // namespace
}  // namespace alidade::test
