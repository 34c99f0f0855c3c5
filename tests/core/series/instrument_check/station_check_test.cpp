#include "core/series/instrument_check/station_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/statistics.h"
#include "tests/core/series/instrument_check/simulated_rounds.h"

namespace alidade::test {
namespace {

const std::vector<Target> fourTargets{{10, 3, 40}, {95, -4, 25}, {200, 12, 60}, {290, 1, 33}};

StationCheck checkOf(const CheckReadings& readings) {
  return checkStation(completeRounds(readings).front());
}

/// Rounds of directions and zenith angles as given, arcseconds, with no difference between the faces.
CheckReadings asGiven(const std::vector<std::vector<double>>& directions,
                      const std::vector<std::vector<double>>& zeniths) {
  CheckReadings readings;
  readings.stations = {"S"};
  readings.targets = {"A", "B", "C", "D"};
  for (std::size_t j = 0; j < directions.size(); ++j)
    for (const int face : {1, 2})
      for (std::size_t k = 0; k < directions[j].size(); ++k) {
        const double alpha = directions[j][k] / 3600, zenith = zeniths[j][k] / 3600;
        readings.readings.push_back({.target = k,
                                     .face = face,
                                     .horizontal = Angle::fromDegrees(face == 1 ? alpha : alpha + 180),
                                     .vertical = Angle::fromDegrees(face == 1 ? zenith : 360 - zenith)});
      }
  return readings;
}

TEST(StationCheck, IsWhatIsWorkedByHand) {
  // B − A is 100″ and 106″: d of B ±3, of A 0; without their means ±1.5 and ∓1.5; Σ r² = 9, ν = 1. The zenith
  // angles of A differ by 4″, of B by 2″: Σ r² = 4 + 4 + 1 + 1, ν = 2.
  const StationCheck check =
      checkOf(asGiven({{7200, 7300}, {9000, 9106}}, {{324000, 288000}, {324004, 287998}}));
  EXPECT_EQ(check.targets, 2U);
  EXPECT_EQ(check.rounds, 2U);
  EXPECT_EQ(check.direction.degreesOfFreedom, 1);
  EXPECT_NEAR(check.direction.s(), 3, 1e-6);  // 1e-6″ is the rounding of angles of a full turn
  EXPECT_EQ(check.vertical.degreesOfFreedom, 2);
  EXPECT_NEAR(check.vertical.s(), std::sqrt(5), 1e-6);
  EXPECT_NEAR(check.collimation.value, 0, 1e-6);
  EXPECT_NEAR(check.index.value, 0, 1e-6);
}

/// The formula of ISO 17123-3 for manual calculation, from the raw readings: Σ r² = Σ d² − Σⱼ(Σₖ d)²/t.
TEST(StationCheck, AgreesWithPlainLoops) {
  const CheckReadings readings = simulatedRounds(
      {.collimation = 4, .tilt = 3, .index = -6, .noise = 2, .circleStepDeg = 25.7}, fourTargets, 7, 11);
  const StationCheck check = checkOf(readings);
  constexpr int n = 7, t = 4;
  double x[n][t], z[n][t];
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < t; ++k) {
      const FaceReading& one = readings.readings[static_cast<std::size_t>(j * 2 * t + k)];
      const FaceReading& two = readings.readings[static_cast<std::size_t>(j * 2 * t + 2 * t - 1 - k)];
      double back = two.horizontal.degrees() - 180;
      if (back - one.horizontal.degrees() > 180) back -= 360;
      if (back - one.horizontal.degrees() < -180) back += 360;
      x[j][k] = (one.horizontal.degrees() + back) / 2;
      z[j][k] = (one.vertical.degrees() - two.vertical.degrees() + 360) / 2 * 3600;
    }
  double directions = 0, zeniths = 0;
  double d[n][t];
  for (int k = 0; k < t; ++k) {
    double mean = 0, meanZ = 0;
    for (int j = 0; j < n; ++j) {
      double reduced = x[j][k] - x[j][0];
      while (reduced < 0) reduced += 360;
      d[j][k] = reduced * 3600;
      mean += d[j][k] / n;
      meanZ += z[j][k] / n;
    }
    for (int j = 0; j < n; ++j) {
      d[j][k] = mean - d[j][k];
      zeniths += (meanZ - z[j][k]) * (meanZ - z[j][k]);
    }
  }
  for (int j = 0; j < n; ++j) {
    double sum = 0;
    for (int k = 0; k < t; ++k) {
      directions += d[j][k] * d[j][k];
      sum += d[j][k];
    }
    directions -= sum * sum / t;
  }
  EXPECT_EQ(check.direction.degreesOfFreedom, 18);
  EXPECT_EQ(check.vertical.degreesOfFreedom, 24);
  // Angles of a turn are known to 1e-10″, sums of 28 squares of some arcseconds to better than 1e-6.
  EXPECT_NEAR(check.direction.s(), std::sqrt(directions / 18), 1e-6);
  EXPECT_NEAR(check.vertical.s(), std::sqrt(zeniths / 24), 1e-6);
}

TEST(StationCheck, FindsTheErrorsOfAnInstrumentWithoutNoise) {
  const StationCheck check = checkOf(
      simulatedRounds({.collimation = 12, .tilt = 20, .index = -7.5}, {{0, 0}, {120, 30}, {240, -20}}, 3, 1));
  ASSERT_TRUE(check.causes.tilt);
  EXPECT_NEAR(check.causes.tilt->collimation, 12, 1e-6);
  EXPECT_NEAR(check.causes.tilt->other, 20, 1e-6);
  EXPECT_NEAR(check.index.value, -7.5, 1e-6);
  EXPECT_NEAR(check.direction.s(), 0, 1e-6);
}

TEST(StationCheck, TellsALineOfSightOffTheAxisFromCollimation) {
  // 0.5 mm at 2.4 m are 43″.
  const std::vector<Target> room{{0, 0, 2.4}, {70, 0, 5}, {150, 0, 12}, {260, 0, 30}};
  const StationCheck check = checkOf(simulatedRounds({.collimation = 5, .eccentricityMm = 0.5}, room, 3, 1));
  ASSERT_TRUE(check.causes.lineOfSight);
  EXPECT_NEAR(check.causes.lineOfSight->other, 0.5, 1e-7);
  EXPECT_NEAR(check.causes.lineOfSight->collimation, 5, 1e-6);
  EXPECT_NEAR(check.perTarget[0].collimation, 5 + 42.97, 0.01);
  EXPECT_FALSE(
      checkOf(simulatedRounds({.collimation = 5}, {{0, 0, 9}, {70, 0, 9.2}}, 3, 1)).causes.lineOfSight)
      << "two percent of distance are no spread";
}

TEST(StationCheck, FollowsTheCourseOverTheRounds) {
  const StationCheck check = checkOf(simulatedRounds({.noise = 0.5, .driftPerRound = 3}, fourTargets, 8, 3));
  EXPECT_FALSE(check.isCircleReset);
  ASSERT_TRUE(check.orientationSlope);
  EXPECT_NEAR(check.orientationSlope->perRound, 3, 3 * check.orientationSlope->u);
  EXPECT_LT(check.orientationSlope->pValue, 0.001);
  EXPECT_EQ(check.course.size(), 8U);
  const StationCheck set = checkOf(simulatedRounds({.noise = 0.5, .circleStepDeg = 45}, fourTargets, 8, 3));
  EXPECT_TRUE(set.isCircleReset);
  EXPECT_FALSE(set.orientationSlope);
}

/// ISO 17123-3 tests each circle separately: readings of the other one change nothing.
TEST(StationCheck, EvaluatesEachCircleByItself) {
  const std::vector<Target> level{{10, 0}, {95, 0}, {200, 0}, {290, 0}};
  CheckReadings readings = simulatedRounds({.collimation = 5, .index = -3, .noise = 1}, level, 4, 8);
  const StationCheck both = checkOf(readings);
  readings.circles = CheckCircles::HorizontalOnly;
  const StationCheck directions = checkOf(readings);
  EXPECT_EQ(directions.direction.s(), both.direction.s());
  EXPECT_NEAR(directions.collimation.value, both.collimation.value, 1e-6) << "level targets: cos e is 1";
  EXPECT_TRUE(std::isnan(directions.vertical.s()));
  EXPECT_TRUE(std::isnan(directions.index.value));
  readings.circles = CheckCircles::VerticalOnly;
  const StationCheck zeniths = checkOf(readings);
  EXPECT_EQ(zeniths.vertical.s(), both.vertical.s());
  EXPECT_EQ(zeniths.index.value, both.index.value);
  EXPECT_TRUE(std::isnan(zeniths.direction.s()));
  EXPECT_TRUE(std::isnan(zeniths.collimation.value));
}

/// Two targets, one near and steep, one far and level: a tilt of 140″ would have the same effect as an offset
/// of 0.12 mm.
TEST(StationCheck, StatesTheMoreUsualOfTwoCausesThatLookAlike) {
  const StationCheck check = checkOf(simulatedRounds(
      {.collimation = 8, .eccentricityMm = 0.117, .noise = 0.5}, {{20, 4, 2.4}, {140, 0, 60}}, 8, 4));
  EXPECT_TRUE(check.causes.isEither);
  EXPECT_FALSE(check.causes.tilt);
  ASSERT_TRUE(check.causes.lineOfSight);
  EXPECT_NEAR(check.causes.lineOfSight->other, 0.117, 4 * check.causes.lineOfSight->uOther);
  EXPECT_NEAR(check.collimation.value, 8, 4 * check.collimation.u);
}

TEST(StationCheck, HasNoScatterWhereNothingRepeats) {
  const StationCheck oneRound = checkOf(simulatedRounds({.collimation = 3, .noise = 1}, fourTargets, 1, 5));
  EXPECT_EQ(oneRound.direction.degreesOfFreedom, 0);
  EXPECT_TRUE(std::isnan(oneRound.direction.s()));
  EXPECT_EQ(oneRound.collimation.degreesOfFreedom, 4 - 2) << "collimation and tilt of four pairs";
  const StationCheck oneTarget = checkOf(simulatedRounds({.noise = 1}, {{10, 2}}, 5, 5));
  EXPECT_EQ(oneTarget.direction.degreesOfFreedom, 0);
  EXPECT_EQ(oneTarget.vertical.degreesOfFreedom, 4);
  EXPECT_FALSE(std::isnan(oneTarget.vertical.s()));
  const StationCheck one = checkOf(simulatedRounds({.noise = 1}, {{10, 2}}, 1, 5));
  EXPECT_TRUE(std::isnan(one.collimation.u));
  EXPECT_TRUE(std::isnan(one.vertical.s()));
}

TEST(StationCheck, OfIdenticalRoundsIsZero) {
  const StationCheck check =
      checkOf(asGiven({{7200, 7300, 9000}, {7200, 7300, 9000}, {7200, 7300, 9000}},
                      {{324000, 288000, 1}, {324000, 288000, 1}, {324000, 288000, 1}}));
  EXPECT_EQ(check.direction.s(), 0);
  EXPECT_EQ(check.vertical.s(), 0);
  EXPECT_NEAR(check.collimation.u, 0, 1e-6);
}

/// Over 2000 draws s² is right on average, and the 95 % intervals contain the true values as often as stated.
TEST(StationCheck, StatesItsUncertaintyAsItIs) {
  constexpr int draws = 2000;
  constexpr double noise = 2;
  const std::vector<Target> targets{{10, 25, 8}, {95, -15, 25}, {200, 40, 60}, {290, 5, 3}};
  int collimation = 0, index = 0, tilt = 0, eccentricity = 0;
  double ofDirections = 0, ofVerticals = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto seed = static_cast<std::uint64_t>(1000 + draw);
    const StationCheck plain = checkOf(simulatedRounds(
        {.collimation = 6, .index = 4, .noise = noise, .circleStepDeg = 61}, targets, 4, seed));
    const auto holds = [](double value, double u, double degreesOfFreedom, double truth) {
      return std::abs(value - truth) <= coverageFactor(0.95, degreesOfFreedom) * u ? 1 : 0;
    };
    collimation += holds(plain.collimation.value, plain.collimation.u, plain.collimation.degreesOfFreedom, 6);
    index += holds(plain.index.value, plain.index.u, plain.index.degreesOfFreedom, 4);
    eccentricity += holds(plain.causes.lineOfSight->other, plain.causes.lineOfSight->uOther,
                          plain.causes.lineOfSight->degreesOfFreedom, 0);
    const StationCheck tilted = checkOf(simulatedRounds(
        {.collimation = 6, .tilt = 15, .noise = noise, .circleStepDeg = 61}, targets, 4, seed));
    tilt += holds(tilted.causes.tilt->other, tilted.causes.tilt->uOther, tilted.causes.tilt->degreesOfFreedom,
                  15);
    ofDirections += plain.direction.s() * plain.direction.s() / draws;
    ofVerticals += plain.vertical.s() * plain.vertical.s() / draws;
  }
  // Binomial, 2000 draws: σ = 0.49 %; 3.5 σ. The weights cos e make those of c and e slightly different.
  for (const int count : {collimation, index, tilt, eccentricity})
    EXPECT_NEAR(static_cast<double>(count) / draws, 0.95, 0.017);
  // s is of the mean of two faces: σ²/2. The mean of 2000 s² with 9 degrees of freedom scatters by 1.05 %.
  EXPECT_NEAR(ofDirections / (noise * noise / 2), 1, 0.035);
  EXPECT_NEAR(ofVerticals / (noise * noise / 2), 1, 0.035);
}

}  // namespace
}  // namespace alidade::test
