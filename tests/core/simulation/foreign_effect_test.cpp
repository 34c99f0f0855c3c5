#include "core/simulation/foreign_effect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"

namespace alidade {
namespace {

using Kind = ForeignEffect::Kind;

Angle degrees(double value) {
  return Angle::fromDegrees(value);
}

TEST(ForeignEffect, FollowsItsFormula) {
  const ForeignEffect dent{.kind = Kind::LocalDent, .size = 0.2, .first = 60, .second = 10};
  EXPECT_DOUBLE_EQ(radiusBy(dent, degrees(60)), 0.2);
  EXPECT_NEAR(radiusBy(dent, degrees(70)), 0.2 * std::exp(-0.5), 1e-12);
  const ForeignEffect periods{.kind = Kind::CirclePeriods, .size = 4, .first = 6, .second = 0};
  EXPECT_NEAR(azimuthBy(periods, degrees(15), 0, false).arcseconds(), 4, 1e-9);
  EXPECT_NEAR(azimuthBy(periods, degrees(195), 0, false).arcseconds(), 4, 1e-9);  // even: equal in both faces
  const ForeignEffect settling{.kind = Kind::Settling, .size = 10, .first = 0.2, .second = 0};
  EXPECT_NEAR(azimuthBy(settling, {}, 0.2, false).arcseconds(), 10 / std::exp(1), 1e-9);
  EXPECT_NEAR(elevationBy(settling, {}, 0).arcseconds(), 10, 1e-9);
  const ForeignEffect refraction{.kind = Kind::Refraction, .size = 10, .first = 0, .second = 0};
  EXPECT_NEAR(elevationBy(refraction, degrees(-15), 0).arcseconds(), -5, 1e-9);
  const ForeignEffect backlash{.kind = Kind::Backlash, .size = 10, .first = 0, .second = 0};
  EXPECT_EQ(azimuthBy(backlash, {}, 0.5, false), Angle());
  EXPECT_NEAR(azimuthBy(backlash, {}, 0.5, true).arcseconds(), 10, 1e-9);
  EXPECT_DOUBLE_EQ(distanceBy({.kind = Kind::DistanceRamp, .size = 2, .first = 0, .second = 0}, 0.25), 0.5);
  EXPECT_NEAR(offPlaneBy({.kind = Kind::HighWarp, .size = 2, .first = 4, .second = 30}, degrees(15)), 2,
              1e-12);
}

// Every kind affects the readings, and each is a separate kind in the truth file.
TEST(ForeignEffect, IsReadByEverySimulatedTheodolite) {
  std::set<std::string> kinds;
  const Protocol& protocol = *protocolByName("there-and-back");
  const Truth plain = drawTruth(2);
  const Session without = *simulateWithoutNoise(protocol, plain, 2);
  for (const ForeignEffectName& name : foreignEffectNames()) {
    Truth truth = plain;
    const std::string numbers = name.numbers == 1 ? "5" : name.numbers == 2 ? "5,0.3" : "5,6,40";
    ASSERT_FALSE(addEffect(truth, std::string(name.name) + "=" + numbers));
    kinds.insert(kindOf(truth));
    EXPECT_NE(simulateWithoutNoise(protocol, truth, 2)->positions, without.positions) << name.name;
    EXPECT_TRUE(addEffect(truth, std::string(name.name) + "=1,2,3,4"));
  }
  EXPECT_EQ(kinds.size(), foreignEffectNames().size());
  EXPECT_TRUE(kinds.contains("unknown_local_dent"));
}

}  // namespace
}  // namespace alidade
