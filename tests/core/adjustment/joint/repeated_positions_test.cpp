#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/adjustment/joint/fast_joint_fit.h"
#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/linearised.h"
#include "core/adjustment/result/session_fit.h"
#include "tests/support/perfect_session.h"

// A repeated axis.

namespace alidade {
namespace {

using enum Unknown::Kind;

constexpr Circle at0{0.3, 1, 400.2}, at180{-0.1, -1, 400.5};

/// 0°, 180°, 0° with zeros known to 2″, and different numbers of points.
Measurement measuredAgain(int points = 13) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(2);
  measurement.arcs = {test::perfectArc(measurement, at0, test::spread(points, 140)),
                      test::perfectArc(measurement, at180, test::spread(points + 4, 150, -90), 180),
                      test::perfectArc(measurement, at0, test::spread(points, 140))};
  measurement.arcs[2].repeat = 2;
  for (std::size_t i = 0; i < measurement.arcs.size(); ++i) {
    measurement.arcs[i].position = i;
    for (Sighting& sighting : measurement.arcs[i].sightings) sighting.sequence = measurement.rows++;
  }
  setMoments(measurement);
  return measurement;
}

/// Simulates a misread zero of an arc.
void turn(ArcMeasurement& arc, double horizontalArcsec, double verticalArcsec) {
  for (Sighting& sighting : arc.sightings) {
    sighting.a = sighting.a + Angle::fromArcseconds(horizontalArcsec);
    sighting.e = sighting.e + Angle::fromArcseconds(verticalArcsec);
  }
}

double valueOf(const JointFit& fit, Unknown::Kind kind, std::size_t arc) {
  return fit.values.at(fit.indexOf({.kind = kind, .arc = arc}));
}

TEST(RepeatedPositions, ShareOneCircle) {
  const Measurement measurement = measuredAgain();
  const SessionFit fit = fitSession(measurement);
  ASSERT_EQ(fit.arcs.size(), 3u);
  for (const std::size_t arc : {0, 2}) {
    EXPECT_NEAR(fit.arcs[arc].circle.x, at0.x, 1e-8);
    EXPECT_NEAR(fit.arcs[arc].circle.y, at0.y, 1e-8);
    EXPECT_NEAR(fit.arcs[arc].circle.radius, at0.radius, 1e-8);
  }
  EXPECT_EQ(fit.arcs[2].repeat, 2);
  EXPECT_NEAR(fit.intersection->value, 1, 1e-8);
  // Degrees of freedom: two readings of each row, minus one place of each row and three numbers of each of
  // two circles. The zeros are observed.
  EXPECT_EQ(fit.joint.degreesOfFreedom, 2 * 43 - 43 - 6);
}

// Two zeros at one axis that differ by δ: whichever is right, the centre is half way. Each zero takes half of
// δ, apart from the part left to the noise of the readings. Δd changes by half of the effect of one zero. In
// closed form for zeros alone: a rotation by δ moves a far centre by L δ.
TEST(RepeatedPositions, MeetHalfWay) {
  constexpr double moved = 20;
  Measurement measurement = measuredAgain();
  turn(measurement.arcs[2], moved, -moved);
  const SessionFit fit = fitSession(measurement);
  const double full = measurement.distance * Angle::fromArcseconds(moved).radians();
  EXPECT_NEAR(fit.arcs[0].circle.x - at0.x, full / 2, 0.03 * full);  // the points of the arc are 400 mm from
                                                                     // its centre
  EXPECT_NEAR(fit.intersection->value - 1, -full / 4, 0.03 * full);
  const double first = valueOf(fit.joint, HorizontalZero, 0), again = valueOf(fit.joint, HorizontalZero, 2);
  EXPECT_NEAR(Angle::fromRadians(first + again).arcseconds(), 0, 1e-3);
  // The estimated difference is a weighted mean of the zeros, which show no difference, and of the arcs
  // alone.
  const double difference = std::abs(Angle::fromRadians(again - first).arcseconds());
  const double ofZero = measurement.distance * measurement.sigmaZeroHorizontal.radians(),
               ofArc = std::sqrt(fitArc(measurement, measurement.arcs[0])->cofactor[0][0]);
  EXPECT_NEAR(difference, moved * ofZero * ofZero / (ofZero * ofZero + ofArc * ofArc), 0.03 * moved);
}

// The axis with two zeros has half the variance due to a single zero, so σ is ½ √(2″²/2 + 2″²) L.
TEST(RepeatedPositions, HalveTheVarianceOfTheirZeros) {
  const Measurement measurement = measuredAgain();
  const SessionFit fit = fitSession(measurement);
  double ofZeros = 0;
  for (const BudgetEntry& entry : fit.intersection->budget)
    if (entry.source == UncertaintySource::PointingZeros) ofZeros = entry.sigma;
  const double one = measurement.distance * Angle::fromArcseconds(2).radians();
  EXPECT_NEAR(ofZeros, std::sqrt(1.5) / 2 * one, 0.03 * one);
}

// σ is as stated: for 400 noisy sessions with zeros off by their σ the mean of (Δd error/σ)² is 1 within four
// times √(2/400).
TEST(RepeatedPositions, AreAsUncertainAsStated) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  double sum = 0;
  constexpr int sessions = 400;
  for (int i = 0; i < sessions; ++i) {
    Measurement measurement = measuredAgain(5 + i % 9);
    for (ArcMeasurement& arc : measurement.arcs) {
      turn(arc, 2 * normal(generator), 2 * normal(generator));
      test::addNoise(arc, measurement, generator);
    }
    const SessionFit fit = fitSession(measurement);
    const double stated = std::sqrt(fit.intersection->sigma * fit.intersection->sigma);
    sum += std::pow((fit.intersection->value - 1) / stated, 2);
  }
  EXPECT_NEAR(sum / sessions, 1, 4 * std::sqrt(2.0 / sessions) + 0.1);  // σ itself is estimated
}

// Arcs that share a centre share the redundancy: over 400 noisy sessions χ² of each arc is on average its
// redundancy, within four times √(2/f) of all sessions. One place more or less is ten times that.
TEST(RepeatedPositions, GiveEachArcItsShareOfTheRedundancy) {
  std::mt19937_64 generator(11);
  std::normal_distribution<double> normal;
  double chiSquare[3] = {}, redundancy[3] = {};
  for (int i = 0; i < 400; ++i) {
    Measurement measurement = measuredAgain(4 + i % 3);
    for (ArcMeasurement& arc : measurement.arcs) {
      turn(arc, 2 * normal(generator), 2 * normal(generator));
      test::addNoise(arc, measurement, generator);
    }
    const JointFit fit = fitSession(measurement).joint;
    for (const std::size_t arc : {0, 1, 2}) {
      chiSquare[arc] += fit.residualSums[arc].chiSquare;
      redundancy[arc] += fit.residualSums[arc].degreesOfFreedom;
    }
  }
  for (const std::size_t arc : {0, 1, 2})
    EXPECT_NEAR(chiSquare[arc] / redundancy[arc], 1, 4 * std::sqrt(2 / redundancy[arc])) << arc;
}

// `isApart` fits each position as if alone, with the fast adjustment and the general one.
TEST(RepeatedPositions, CanBeFittedApart) {
  Measurement measurement = measuredAgain();
  turn(measurement.arcs[2], 10, 5);
  std::vector<Circle> starts;
  for (const ArcMeasurement& arc : measurement.arcs) starts.push_back(fitArc(measurement, arc)->circle);
  const auto fast = fitJointlyFast(measurement, starts, {.isApart = true});
  ASSERT_TRUE(fast);
  const JointFit general = fitJointlyInGeneral(measurement, starts, {.isApart = true});
  for (const JointFit* fit : {&*fast, &general})
    for (std::size_t arc = 0; arc < 3; ++arc) {
      EXPECT_NEAR(fit->circleOf(arc).x, starts[arc].x, 1e-8);
      EXPECT_NEAR(fit->circleOf(arc).y, starts[arc].y, 1e-8);
      EXPECT_NEAR(fit->circleOf(arc).radius, starts[arc].radius, 1e-8);
    }
  EXPECT_FALSE(fitJointlyFast(measurement, starts)) << "they have a centre in common";
}

// The readings of all arcs that share a centre have derivatives with respect to it.
TEST(RepeatedPositions, AllHangOnTheSharedUnknowns) {
  const Measurement measurement = measuredAgain();
  const SessionFit fit = fitSession(measurement);
  const Linearised equations = linearise(measurement, fit.joint);
  const auto x = static_cast<std::size_t>(
      std::ranges::find(equations.unknowns, Unknown{.kind = CentreX, .arc = 0}) - equations.unknowns.begin());
  for (std::size_t i = 0; i < equations.readings.size(); ++i)
    if (equations.readings[i].kind == ReadingKind::Horizontal) {
      EXPECT_EQ(equations.ofUnknown(i, x) != 0, measurement.arcs[equations.readings[i].arc].axisDeg == 0);
    }
}

// 0° and 0° only: one centre, and no intersection.
TEST(RepeatedPositions, MakeNoIntersectionByThemselves) {
  Measurement measurement = measuredAgain();
  measurement.arcs.erase(measurement.arcs.begin() + 1);
  const SessionFit fit = fitSession(measurement);
  ASSERT_EQ(fit.arcs.size(), 2u);
  EXPECT_NEAR(fit.arcs[1].circle.y, at0.y, 1e-8);
  EXPECT_FALSE(fit.intersection);
}

// The published method has no common centre: Δd uses the mean.
TEST(RepeatedPositions, AreAveragedByThePublishedMethod) {
  Measurement measurement = measuredAgain();
  turn(measurement.arcs[2], 0, 30);
  const PublishedSessionFit all = fitSessionAsPublished(measurement);
  const auto without = [&](std::ptrdiff_t arc) {
    Measurement part = measurement;
    part.arcs.erase(part.arcs.begin() + arc);
    return fitSessionAsPublished(part);
  };
  EXPECT_NEAR(*all.intersection, (*without(0).intersection + *without(2).intersection) / 2, 1e-12);
  EXPECT_NEAR(*all.intersectionAsPrinted,
              (*without(0).intersectionAsPrinted + *without(2).intersectionAsPrinted) / 2, 1e-12);
}

}  // namespace
}  // namespace alidade
