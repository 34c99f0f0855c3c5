#include "core/adjustment/joint/sighted_zeros.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/joint/linearised.h"
#include "core/adjustment/result/closures.h"
#include "core/adjustment/result/session_fit.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

/// Returns a session of the paper's plan without noise.
Measurement readWith(const std::vector<TrueSize>& effects, bool zerosInFull = false) {
  Truth truth = drawTruth(5);
  truth.effects = effects;
  truth.sightsZerosInFull = zerosInFull;
  return test::measurementOf(*simulateWithoutNoise(*protocolByName("paper"), truth, 5));
}

std::vector<Circle> circlesOf(const Measurement& measurement) {
  std::vector<Circle> circles;
  for (const ArcFit& arc : fitSession(measurement).arcs) circles.push_back(arc.circle);
  return circles;
}

TEST(SightedZeros, AreCommonWhereTheySightOneMark) {
  Measurement measurement = readWith({});
  measurement.arcs[1].zeroHorizontal = measurement.arcs[1].zeroHorizontal + Angle::fromArcseconds(5);
  EXPECT_EQ(commonZeros(measurement), (CommonZeros{true, true}));
  EXPECT_FALSE(areZerosInDoubt(measurement));
  for (const ZeroIs none : {ZeroIs::Normal, ZeroIs::Unknown}) {
    measurement.zeroIs = none;
    EXPECT_EQ(commonZeros(measurement), CommonZeros{});
  }
}

TEST(SightedZeros, HaveNoCommonDirectionOnACircleThatWasSetAnew) {
  Measurement measurement = readWith({});
  measurement.arcs[1].zeroHorizontal = measurement.arcs[1].zeroHorizontal + Angle::fromDegrees(60);
  EXPECT_EQ(commonZeros(measurement), (CommonZeros{false, true}));
  EXPECT_FALSE(areZerosInDoubt(measurement));
}

TEST(SightedZeros, AreInDoubtFromThirtySecondsOnUntilItIsStated) {
  Measurement measurement = readWith({});
  measurement.arcs[1].zeroHorizontal = measurement.arcs[1].zeroHorizontal + Angle::fromArcseconds(29);
  EXPECT_FALSE(areZerosInDoubt(measurement));
  measurement.arcs[1].zeroHorizontal = measurement.arcs[1].zeroHorizontal + Angle::fromArcseconds(2);
  EXPECT_TRUE(areZerosInDoubt(measurement));
  measurement.zeroIs = ZeroIs::Mark;
  EXPECT_FALSE(areZerosInDoubt(measurement));
}

// A horizontal circle may be set anew; a vertical one counts from the plumb line. So one degree between the
// vertical zeros of one mark is a misreading, however large.
TEST(SightedZeros, AreNeverOfAVerticalCircleThatWasSetAnew) {
  for (const double degrees : {1.01, 10.0}) {
    Measurement measurement = readWith({});
    measurement.arcs[1].zeroElevation = measurement.arcs[1].zeroElevation + Angle::fromDegrees(degrees);
    EXPECT_EQ(commonZeros(measurement), (CommonZeros{true, true}));
    EXPECT_TRUE(areZerosInDoubt(measurement));
    measurement.zeroIs = ZeroIs::Mark;
    EXPECT_EQ(commonZeros(measurement), (CommonZeros{true, true}));
  }
}

// Zeros that are identical to the last digit may be a single sighting with a common error.
TEST(SightedZeros, WrittenAlikeSayNothingOfTheTimeBetween) {
  Measurement measurement = readWith({});
  measurement.arcs[1].zeroHorizontal = measurement.arcs[0].zeroHorizontal;
  measurement.arcs[1].zeroElevation = measurement.arcs[0].zeroElevation;
  measurement.arcs[1].zeroVertical = measurement.arcs[0].zeroVertical;
  measurement.pointingZeros = PointingZeros::Unstated;
  EXPECT_EQ(commonZeros(measurement), CommonZeros{});
  measurement.pointingZeros = PointingZeros::Each;
  EXPECT_EQ(commonZeros(measurement), (CommonZeros{true, true}));
}

// The zeros are sighted next to the first and the 18th of 34 rows: between them a drift turns the orientation
// by 17/33 of its size.
TEST(SightedZeros, DifferByWhatADriftTurnsBetweenThem) {
  const Measurement measurement =
      readWith({{ErrorTerm::HorizontalDrift, 66}, {ErrorTerm::VerticalDrift, -33}});
  const double perSecond = 2405 * Angle::fromArcseconds(1).radians();
  const auto closures = zeroClosuresOf(measurement, fitSession(measurement).joint, {});
  ASSERT_EQ(closures.size(), 2u);
  // Typed to 1e-6″.
  EXPECT_NEAR(closures[0].value / perSecond, 66 * 17.0 / 33, 1e-4);
  EXPECT_NEAR(closures[1].value / perSecond, 33 * 17.0 / 33, 1e-4) << "up, where zenith angles grow";
  EXPECT_NEAR(closures[0].sigma / perSecond, 2 * std::sqrt(2), 1e-9);
}

// As observations the zeros determine the drift, and with it the arcs: readings without noise leave no
// residuals.
TEST(SightedZeros, BringADriftBackToTheDigit) {
  for (const bool inFull : {false, true}) {
    const Measurement read =
        readWith({{ErrorTerm::HorizontalDrift, 40}, {ErrorTerm::VerticalDrift, 25}}, inFull);
    const Measurement closed = withZerosSighted(read);
    const double free = std::numeric_limits<double>::infinity();
    const JointFit fit = fitJointly(
        closed, circlesOf(read),
        {.terms = {{ErrorTerm::HorizontalDrift, free}, {ErrorTerm::VerticalDrift, free}}, .isClosed = true});
    ASSERT_TRUE(fit.converged());
    const auto drift = [&](ErrorTerm term) {
      const std::size_t at = fit.indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = term});
      return Angle::fromRadians(fit.values[at]).arcseconds();
    };
    EXPECT_NEAR(drift(ErrorTerm::HorizontalDrift), 40, 1e-4);
    EXPECT_NEAR(drift(ErrorTerm::VerticalDrift), 25, 1e-4);
    EXPECT_LT(fit.chiSquare, 1e-6);
  }
}

TEST(SightedZeros, LeaveTheRowsWhereTheyAre) {
  Measurement read = readWith({}, true);
  const Measurement closed = withZerosSighted(read);
  for (std::size_t arc = 0; arc < 2; ++arc) {
    ASSERT_EQ(closed.arcs[arc].sightings.size(), read.arcs[arc].sightings.size() + 4);
    for (std::size_t i = 0; i < read.arcs[arc].sightings.size(); ++i)
      EXPECT_EQ(closed.arcs[arc].sightings[i].row, read.arcs[arc].sightings[i].row);
    // Each position has two sightings of the zero before its rows and two after them, all at different
    // moments.
    const ArcMeasurement& own = read.arcs[arc];
    EXPECT_LT(own.zeroSightings[1].order, own.sightings.front().order);
    EXPECT_GT(own.zeroSightings[2].order, own.sightings.back().order);
    EXPECT_DOUBLE_EQ(own.zeroSightings[2].elapsed, own.sightings.back().elapsed);
  }
}

/// The linearised residuals of the zeros must have the derivatives known in closed form, with respect to
/// terms of the instrument and both zeros.
TEST(SightedZeros, HaveTheDerivativesOfTheirMark) {
  Measurement read = readWith({{ErrorTerm::Collimation, 40}, {ErrorTerm::HorizontalDrift, 30}}, true);
  read.arcs[0].zeroElevation = read.arcs[1].zeroElevation = Angle::fromDegrees(1);
  const Measurement closed = withZerosSighted(read);
  const JointFit fit = fitJointly(closed, circlesOf(read), {.isClosed = true});
  const Linearised linear = linearise(closed, fit, {.isClosed = true});
  int zeros = 0;
  for (std::size_t i = 0; i < linear.readings.size(); ++i) {
    if (!linear.readings[i].isZero) continue;
    ++zeros;
    const Sighting& zero = closed.arcs[linear.readings[i].arc].sightings[linear.readings[i].sighting];
    const bool isVertical = linear.readings[i].kind == ReadingKind::Vertical;
    const double sigma = linear.readings[i].sigma, side = zero.face == 1 ? 1 : -1;
    // δα = ±c/cos e at the mark; a drift acts at the moment of the sighting, separately on the two circles.
    EXPECT_NEAR(linear.ofTerm(i, ErrorTerm::Collimation) * sigma,
                isVertical ? 0 : side / std::cos(Angle::fromDegrees(1).radians()), 1e-3);
    EXPECT_NEAR(linear.ofTerm(i, ErrorTerm::HorizontalDrift) * sigma, isVertical ? 0 : zero.elapsed, 1e-12);
    EXPECT_NEAR(linear.ofTerm(i, ErrorTerm::VerticalDrift) * sigma, isVertical ? -zero.elapsed : 0, 1e-12);
    EXPECT_EQ(linear.ofTerm(i, ErrorTerm::GravitySag), 0);
    for (std::size_t u = 0; u < linear.unknowns.size(); ++u) {
      const Unknown::Kind kind = linear.unknowns[u].kind;
      const double expected = kind == Unknown::Kind::HorizontalZero && !isVertical ? -1
                              : kind == Unknown::Kind::VerticalZero && isVertical  ? 1
                                                                                   : 0;
      EXPECT_NEAR(linear.ofUnknown(i, u) * sigma, expected, 1e-9);
    }
  }
  EXPECT_EQ(zeros, 16);
}

}  // namespace
}  // namespace alidade
