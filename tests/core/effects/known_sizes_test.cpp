#include "core/effects/known_sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace alidade {
namespace {

constexpr double arcsec = std::numbers::pi / 180 / 3600;

TEST(KnownSizes, AreOfTheNumberTheyName) {
  const EffectParameter* collimation = findParameter("collimation", "", "arcsec");
  ASSERT_TRUE(collimation);
  EXPECT_EQ(collimation->term, ErrorTerm::Collimation);
  const EffectParameter* tilt = findParameter("plane_tilt", "tilt about y", "deg");
  ASSERT_TRUE(tilt);
  EXPECT_EQ(tilt->term, ErrorTerm::PlaneTiltY);
}

TEST(KnownSizes, AreOfNothingElse) {
  for (const KnownNumber& known :
       {KnownNumber{.effect = "moonlight", .unit = "arcsec"},
        KnownNumber{.effect = "collimation", .unit = "mm"},
        KnownNumber{.effect = "collimation", .parameter = "tilt", .unit = "arcsec"},
        KnownNumber{.effect = "plane_tilt", .unit = "deg"},  // which of two?
        KnownNumber{.effect = "vertical_angle_relation", .unit = "-"}})
    EXPECT_FALSE(findParameter(known.effect, known.parameter, known.unit)) << known.effect << known.parameter;
}

TEST(KnownSizes, AreOfEffectsThatHaveASize) {
  EXPECT_TRUE(hasSizes(*effectById("collimation")));
  EXPECT_FALSE(hasSizes(*effectById("vertical_angle_relation"))) << "it is so or not";
}

// 3 ± 1 and 5 ± 2 weigh 4 to 1: 3.4 ± 2/√5.
TEST(KnownSizes, AreWeighedTogether) {
  Measurement measurement;
  const EffectParameter& collimation = effectById("collimation")->parameters.front();
  EXPECT_FALSE(knownOf(measurement, collimation));
  measurement.known = {{.effect = "collimation", .unit = "arcsec", .from = "a", .value = 3, .sigma = 1},
                       {.effect = "collimation", .unit = "arcsec", .from = "b", .value = 5, .sigma = 2},
                       {.effect = "trunnion_tilt", .unit = "arcsec", .value = 9, .sigma = 0.1}};
  const KnownPrior known = *knownOf(measurement, collimation);
  EXPECT_NEAR(known.value, 3.4 * arcsec, 1e-12);
  EXPECT_NEAR(known.sigma, 2 / std::sqrt(5) * arcsec, 1e-12);
  EXPECT_EQ(known.from, "a; b");
}

TEST(KnownSizes, AreAsDoubtfulAsTheLeastCertainAndAsNewAsTheNewest) {
  Measurement measurement;
  measurement.known = {
      {.effect = "collimation", .unit = "arcsec", .date = "2026-03-01", .sigma = 1},
      {.effect = "collimation", .unit = "arcsec", .date = "2025-03-01", .sigma = 1, .staleChance = 0.3}};
  const KnownPrior known = *knownOf(measurement, effectById("collimation")->parameters.front());
  EXPECT_EQ(known.staleChance, 0.3);
  EXPECT_EQ(known.date, "2026-03-01");
  EXPECT_EQ(staleChanceOf(measurement, *effectById("collimation")), 0.3);
  EXPECT_EQ(staleChanceOf(measurement, *effectById("trunnion_tilt")), 0);
}

TEST(KnownSizes, AreOfAnEffectWhereTheyAreOfAllItsNumbers) {
  Measurement measurement;
  EXPECT_FALSE(isAnythingKnown(measurement));
  measurement.known = {{.effect = "plane_tilt", .parameter = "tilt about x", .unit = "deg", .sigma = 1}};
  EXPECT_TRUE(isAnythingKnown(measurement));
  EXPECT_FALSE(knownOf(measurement, *effectById("plane_tilt")));
  measurement.known.push_back(measurement.known.front());
  measurement.known.back().parameter = "tilt about y";
  EXPECT_EQ(knownOf(measurement, *effectById("plane_tilt"))->size(), 2u);
  measurement.known = {{.effect = "moonlight", .unit = "arcsec", .sigma = 1}};
  EXPECT_FALSE(isAnythingKnown(measurement)) << "of no number of the catalogue";
}

}  // namespace
}  // namespace alidade
