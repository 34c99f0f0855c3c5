#include "core/base/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace alidade {
namespace {

TEST(Angle, NamesItsUnits) {
  EXPECT_DOUBLE_EQ(Angle::fromDegrees(180).radians(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(Angle::fromGon(400).degrees(), 360);
  EXPECT_DOUBLE_EQ(Angle::fromArcseconds(3600).degrees(), 1);
  EXPECT_DOUBLE_EQ(Angle::fromDegrees(-2).arcseconds(), -7200);
}

TEST(Angle, WrappingLeavesValuesInRangeUntouched) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> degrees(0, 360);
  for (int i = 0; i < 10000; ++i) {
    const Angle angle = Angle::fromDegrees(degrees(random));
    EXPECT_EQ(wrapped(angle, Angle::fromDegrees(180)), angle);
  }
}

TEST(Angle, WrapsAcrossTheZeroOfTheCircle) {
  EXPECT_NEAR(wrapped(Angle::fromDegrees(359) - Angle::fromDegrees(1)).degrees(), -2, 1e-12);
  EXPECT_NEAR(wrapped(Angle::fromDegrees(-2), Angle::fromDegrees(180)).degrees(), 358, 1e-12);
  EXPECT_NEAR(wrapped(Angle::fromDegrees(725)).degrees(), 5, 1e-12);
}

TEST(Angle, WrappingIncludesTheLowerEndAndExcludesTheUpper) {
  EXPECT_DOUBLE_EQ(wrapped(Angle::fromDegrees(180)).degrees(), -180);
  EXPECT_DOUBLE_EQ(wrapped(Angle::fromDegrees(-180)).degrees(), -180);
  EXPECT_DOUBLE_EQ(wrapped(Angle::fromDegrees(540)).degrees(), -180);
  EXPECT_NEAR(wrapped(Angle::fromDegrees(360), Angle::fromDegrees(180)).degrees(), 0, 1e-13);
}

// This holds for any centre, whatever its own rounding.
TEST(Angle, WrappingLeavesTheLowerEndUntouched) {
  for (int i = -1000; i <= 1000; ++i) {
    const Angle centre = Angle::fromRadians(0.01 * i);
    const Angle low = Angle::fromRadians(centre.radians() - std::numbers::pi);
    EXPECT_EQ(wrapped(low, centre), low) << i;
  }
}

TEST(Angle, WrappingStaysInRangeForAnySizeAndDiffersByWholeTurns) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-3, 6), sign(-1, 1), centres(-10, 10);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::copysign(std::pow(10, exponent(random)), sign(random));
    const Angle centre = Angle::fromRadians(centres(random));
    const double result = wrapped(Angle::fromRadians(value), centre).radians();
    ASSERT_GE(result, centre.radians() - std::numbers::pi);
    ASSERT_LT(result, centre.radians() + std::numbers::pi);
    const double turns = (value - result) / (2 * std::numbers::pi);
    ASSERT_NEAR(turns, std::round(turns), 1e-9) << value;
  }
}

TEST(Angle, WrappingKeepsWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(wrapped(Angle::fromRadians(nan)).radians()));
  EXPECT_TRUE(std::isnan(wrapped(Angle::fromRadians(std::numeric_limits<double>::infinity())).radians()));
}

TEST(MeanDirection, DoesNotDependOnWhereDirectionsAreWrapped) {
  for (const double turned : {0.0, 90.0, 179.9, 180.0, 270.0}) {
    MeanDirection mean;
    for (const double degrees : {-0.3, 0.1, 0.2})
      mean.add(wrapped(Angle::fromDegrees(degrees + turned), Angle::fromDegrees(180)));
    EXPECT_NEAR(wrapped(mean.value() - Angle::fromDegrees(turned)).degrees(), 0, 1e-6) << turned;
  }
  EXPECT_EQ(MeanDirection().value().degrees(), 0);
}

}  // namespace
}  // namespace alidade
