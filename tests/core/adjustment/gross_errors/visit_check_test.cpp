#include "core/adjustment/gross_errors/visit_check.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/perfect_session.h"

namespace alidade::test {
namespace {

const std::vector<Circle> circles{{0.4, 1.2, 400.3}, {0.4, -1.2, 400.3}};

/// Two noisy arcs of 17 places, 10° apart, the second run the other way.
Measurement noisyThereAndBack(unsigned seed) {
  std::mt19937_64 generator(seed);
  Measurement measurement = usualMeasurement();
  measurement.arcs = {perfectArc(measurement, circles[0], spread(17, 160), 0),
                      perfectArc(measurement, circles[1], spread(17, -160, -90), 180)};
  for (ArcMeasurement& arc : measurement.arcs) addNoise(arc, measurement, generator);
  return measurement;
}

VisitCheck checkOf(const Measurement& measurement, std::size_t arc, int point,
                   const std::vector<Circle>& starts) {
  const JointFitOptions options{.without = readingsOf(measurement, arc, 1, point)};
  return VisitCheck(measurement, arc, options.without, fitJointly(measurement, starts, options), options);
}

VisitAgreement agreementOf(const Measurement& measurement, std::size_t arc, const Sighting& sighting) {
  const VisitCheck check = checkOf(measurement, arc, sighting.point, circles);
  EXPECT_TRUE(check.canCheck());
  return check.agreement({sighting});
}

// The probability of a sound visit is uniform over 0…1, for any noise: its mean over 170 visits is 1/2 within
// four times 0.29/√170.
TEST(VisitCheck, GivesSoundVisitsEvenlySpreadProbabilities) {
  double sum = 0;
  int visits = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Measurement measurement = noisyThereAndBack(seed);
    for (std::size_t arc = 0; arc < 2; ++arc)
      for (const Sighting& sighting : measurement.arcs[arc].sightings) {
        sum += agreementOf(measurement, arc, sighting).probability;
        ++visits;
      }
  }
  EXPECT_EQ(visits, 170);
  EXPECT_NEAR(sum / visits, 0.5, 4 * 0.29 / std::sqrt(170));
}

// At the top of the arc the vertical circle reads across it: 60″ are 30σ.
TEST(VisitCheck, SeesWhatIsOffTheArc) {
  const Measurement measurement = noisyThereAndBack(3);
  Sighting sighting = measurement.arcs[0].sightings[8];
  sighting.e = sighting.e + Angle::fromArcseconds(60);
  const VisitAgreement agreement = agreementOf(measurement, 0, sighting);
  EXPECT_EQ(agreement.tests, 1);
  EXPECT_LT(agreement.probability, 1e-6);
  EXPECT_NEAR(Angle::fromRadians(agreement.residuals[1]).arcseconds(), 60, 8);
}

// A point moved along the arc is still on the arc, but its place is wrong: 10′ of direction are 1° of arc.
TEST(VisitCheck, PrefersThePlaceThatKeepsTheSpacing) {
  const Measurement measurement = noisyThereAndBack(4);
  Sighting sighting = measurement.arcs[0].sightings[8];
  const VisitAgreement inPlace = agreementOf(measurement, 0, sighting);
  sighting.a = sighting.a + Angle::fromArcseconds(600);
  const VisitAgreement besides = agreementOf(measurement, 0, sighting);
  EXPECT_LT(besides.logLikelihood, inPlace.logLikelihood - 3);
}

TEST(VisitCheck, CannotCheckWithoutOtherReadings) {
  Measurement measurement = usualMeasurement();
  measurement.arcs = {perfectArc(measurement, circles[0], spread(4, 120))};
  EXPECT_FALSE(checkOf(measurement, 0, 2, {circles[0]}).canCheck());
}

}  // namespace
}  // namespace alidade::test
