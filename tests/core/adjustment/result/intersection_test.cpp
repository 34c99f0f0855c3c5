#include "core/adjustment/result/intersection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/arc/arc_fit.h"
#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

JointFit fitted(const Measurement& measurement) {
  std::vector<Circle> starts;
  for (const ArcMeasurement& arc : measurement.arcs) starts.push_back(fitArc(measurement, arc)->circle);
  return fitJointly(measurement, starts);
}

double share(const Intersection& intersection, UncertaintySource source) {
  for (const BudgetEntry& entry : intersection.budget)
    if (entry.source == source) return entry.sigma;
  ADD_FAILURE() << "no share of " << static_cast<int>(source);
  return 0;
}

// The figures are from independent solvers; the tolerance is half a unit of their last digit.
TEST(Intersection, OfTableIMeetsTheIndependentSolution) {
  const Measurement measurement = test::paperMeasurement();
  const JointFit fit = fitted(measurement);
  const auto intersection = intersect(measurement, fit);
  ASSERT_TRUE(intersection);
  EXPECT_NEAR(intersection->value, 1.307818, 1e-6);
  EXPECT_NEAR(intersection->inPlane, 1.34739, 0.5e-5);
  EXPECT_NEAR(noiseScale(fit).factor, 6.91, 0.005);
  EXPECT_NEAR(share(*intersection, UncertaintySource::Readings), 0.1018, 0.5e-4);
  EXPECT_NEAR(share(*intersection, UncertaintySource::Readings) / noiseScale(fit).factor, 0.0147, 0.5e-4);
}

TEST(Intersection, PlanarRelationGivesItsOwnValue) {
  Measurement measurement = test::paperMeasurement();
  measurement.relation = VerticalAngleRelation::Planar;
  // The value is from tests/reference/high-precision.
  EXPECT_NEAR(intersect(measurement, fitted(measurement))->value, 1.2303960656054, 1e-9);
}

// A pointing zero off by δ moves its arc by about L·δ; two independent ones move half the difference by
// L·δ/√2.
TEST(Intersection, PaysForThePointingZeros) {
  Measurement measurement = test::paperMeasurement();
  const Intersection intersection = *intersect(measurement, fitted(measurement));
  const double expected = measurement.distance * measurement.sigmaZeroVertical.radians() / std::sqrt(2);
  EXPECT_NEAR(share(intersection, UncertaintySource::PointingZeros), expected, 0.05 * expected);

  measurement.sigmaZeroVertical = measurement.sigmaZeroHorizontal = {};
  EXPECT_EQ(share(*intersect(measurement, fitted(measurement)), UncertaintySource::PointingZeros), 0);
}

// All lengths are proportional to L, so Δd has the same relative error as L.
TEST(Intersection, PaysForTheDistanceInProportion) {
  Measurement measurement = test::paperMeasurement();
  measurement.sigmaDistance = 5;
  const Intersection intersection = *intersect(measurement, fitted(measurement));
  EXPECT_NEAR(share(intersection, UncertaintySource::Distance), 5 / measurement.distance * intersection.value,
              1e-5);
}

TEST(Intersection, CombinesItsBudget) {
  Measurement measurement = test::paperMeasurement();
  measurement.sigmaDistance = 1;
  const Intersection intersection = *intersect(measurement, fitted(measurement));
  double sum = 0;
  for (const BudgetEntry& entry : intersection.budget) sum += entry.sigma * entry.sigma;
  EXPECT_DOUBLE_EQ(intersection.sigma * intersection.sigma, sum);
  EXPECT_DOUBLE_EQ(intersection.expanded, intersection.coverageFactor * intersection.sigma);
  // 28 degrees of freedom, slightly more due to the part that was not estimated: k between t(31) = 2.040 and
  // t(28) = 2.048.
  EXPECT_GT(intersection.effectiveDegreesOfFreedom, 28);
  EXPECT_LT(intersection.effectiveDegreesOfFreedom, 31);
  EXPECT_GT(intersection.coverageFactor, 2.040);
  EXPECT_LT(intersection.coverageFactor, 2.048);
}

// Guide to the expression of uncertainty (JCGM 100), G.2b: ν = u⁴/Σ(uᵢ⁴/νᵢ). Only the readings' contribution
// is estimated, with 28 degrees of freedom; zeros with twice that contribution increase ν at least
// sixteenfold. With so many degrees of freedom k is the normal one to 0.4 %: t(∞) = 1.960.
TEST(Intersection, CountsDegreesOfFreedomAfterWelchAndSatterthwaite) {
  Measurement measurement = test::paperMeasurement();
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(25);
  const Intersection intersection = *intersect(measurement, fitted(measurement));
  const double readings = share(intersection, UncertaintySource::Readings);
  const double variance = std::pow(readings, 2) +
                          std::pow(share(intersection, UncertaintySource::PointingZeros), 2) +
                          std::pow(share(intersection, UncertaintySource::Distance), 2);
  ASSERT_GT(variance, 4 * readings * readings);
  const double expected = variance * variance / (std::pow(readings, 4) / 28);
  EXPECT_NEAR(intersection.effectiveDegreesOfFreedom, expected, 1e-6 * expected);
  EXPECT_NEAR(intersection.coverageFactor, 1.960, 0.006);
}

// The scatter of Table I is not trusted below its 0.1 % point, χ²(28) = 10.391 in the tables. Its χ² is 28 ·
// 6.91² with 2″ and decreases with the square of the stated σ.
TEST(Intersection, BelievesAScatterDownToItsLowestThousandth) {
  Measurement measurement = test::paperMeasurement();
  const auto factorWith = [&](double chiSquare) {
    const double arcsec = 2 * 6.91 * std::sqrt(28 / chiSquare);
    measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(arcsec);
    return fitSession(measurement).noise.factor;
  };
  EXPECT_NEAR(factorWith(10.6), std::sqrt(10.6 / 28), 0.001);
  EXPECT_EQ(factorWith(10.2), 1);
}

// "readings" is their contribution if the effect were known, that is without it in the model. The additional
// cost of determining its size is the effect's share. A drift, correlated with the height of an arc that
// takes as long, costs about as much again.
TEST(Intersection, PaysForAnEffectThatIsEstimatedAlong) {
  Measurement measurement = test::usualMeasurement();
  for (const int axisDeg : {0, 180}) {
    measurement.arcs.push_back(
        test::perfectArc(measurement, {0, 0, 400}, test::spread(17, 160, axisDeg == 0 ? 90 : 270), axisDeg));
    for (Sighting& sighting : measurement.arcs.back().sightings) sighting.sequence = measurement.rows++;
  }
  setMoments(measurement);
  const Intersection without = *fitSession(measurement).intersection;
  measurement.pointingZeros = PointingZeros::One;  // with its own zero, each position would absorb most of a
                                                   // drift
  setMoments(measurement);
  measurement.effects = {"vertical_drift"};
  const SessionFit fit = fitSession(measurement);
  EXPECT_NEAR(share(*fit.intersection, UncertaintySource::Readings),
              share(without, UncertaintySource::Readings), 1e-6);
  EXPECT_GT(share(*fit.intersection, UncertaintySource::ModelEffects),
            0.3 * share(without, UncertaintySource::Readings));
  const auto variance = [&](std::size_t arc) {
    const std::size_t i = fit.joint.indexOf({.kind = Unknown::Kind::CentreY, .arc = arc});
    const std::size_t j = fit.joint.indexOf({.kind = Unknown::Kind::CentreY, .arc = 1 - arc});
    return (fit.joint.cofactor(i, i) - fit.joint.cofactor(i, j)) / 4;
  };
  EXPECT_NEAR(fit.intersection->sigma, std::sqrt(variance(0) + variance(1)), 1e-9);
}

// A plausible size is not a reading: whatever the scatter, an effect that the readings do not show keeps its
// prior uncertainty, here 1 mm of a plane's offset, which Table I does not show.
TEST(Intersection, TakesPlausibleSizesAsTheyAre) {
  Measurement measurement = test::paperMeasurement();
  measurement.effects = {"plane_offset"};
  const SessionFit fit = fitSession(measurement);
  EXPECT_GT(fit.noise.factor, 6);
  EXPECT_NEAR(fit.effects.at(0).value, 0, 0.01);
  EXPECT_NEAR(fit.effects.at(0).sigma, 1, 0.01);
}

// The zeros of Table I scatter like its readings, 6.91 times the 2″ of the circles, if they have no stated σ.
// They scatter at least as stated if the readings scatter less.
TEST(Intersection, HasZerosScatterAsTheReadingsWhereNothingIsStatedOfThem) {
  Measurement measurement = test::paperMeasurement();
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(2);
  const auto ofZeros = [&](bool areReadings) {
    measurement.zerosAreReadings = areReadings;
    return share(*fitSession(measurement).intersection, UncertaintySource::PointingZeros);
  };
  EXPECT_NEAR(ofZeros(true) / ofZeros(false), fitSession(measurement).noise.factor, 1e-9);
  measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(20);
  EXPECT_LT(fitSession(measurement).noise.factor, 1);
  EXPECT_EQ(ofZeros(true), ofZeros(false));
}

TEST(Intersection, NeedsBothPositions) {
  Measurement measurement = test::paperMeasurement();
  measurement.arcs.pop_back();
  EXPECT_FALSE(intersect(measurement, fitted(measurement)));
}

Measurement simulated(std::mt19937_64& generator, int places, double noiseFactor) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(2);
  Measurement noise = measurement;
  noise.sigmaHorizontal = noise.sigmaVertical = Angle::fromArcseconds(2 * noiseFactor);
  std::normal_distribution<double> normal;
  for (const int axisDeg : {0, 180}) {
    ArcMeasurement arc = test::perfectArc(measurement, {0, axisDeg == 0 ? 0.5 : -0.5, 400},
                                          test::spread(places, 150, axisDeg == 0 ? 90 : 270), axisDeg);
    test::addNoise(arc, noise, generator);
    const Angle zero = measurement.sigmaZeroVertical * normal(generator);
    for (Sighting& sighting : arc.sightings) sighting.e = sighting.e + zero;
    measurement.arcs.push_back(arc);
  }
  return measurement;
}

// 95 % intervals contain the truth in 95 % of sessions, whether the stated noise is right or half the true
// one, with ample and with scant redundancy. For 3000 sessions the share scatters by 0.4 %; 1.5 % is nearly
// four times that.
TEST(Intersection, IntervalsCoverTheTruthAsStated) {
  std::mt19937_64 generator(17);
  for (const int places : {5, 17})
    for (const double noiseFactor : {1.0, 2.0}) {
      constexpr int count = 3000;
      int covered = 0;
      for (int i = 0; i < count; ++i) {
        const Measurement measurement = simulated(generator, places, noiseFactor);
        const Intersection intersection = *intersect(measurement, fitted(measurement));
        covered += std::abs(intersection.value - 0.5) <= intersection.expanded;
      }
      EXPECT_NEAR(static_cast<double>(covered) / count, 0.95, 0.015)
          << places << " places, noise × " << noiseFactor;
    }
}

TEST(Intersection, TakesTheStatedNoiseWhereNothingChecksIt) {
  Measurement measurement = test::usualMeasurement();
  for (const int axisDeg : {0, 180})
    measurement.arcs.push_back(
        test::perfectArc(measurement, {0, 0, 400}, test::spread(3, 150, axisDeg == 0 ? 90 : 270), axisDeg));
  const Intersection intersection = *intersect(measurement, fitted(measurement));
  EXPECT_EQ(noiseScale(fitted(measurement)).factor, 1);
  EXPECT_NEAR(intersection.coverageFactor, 1.960, 0.0005);
  EXPECT_GT(intersection.sigma, 0);
}

// The budget of Δd follows from those of the heights: readings and zeros of the two arcs are independent, so
// their variances add up to four times Δd's. A distance error moves heights on either side of the zero
// direction in opposite directions, and Δd by half of that.
TEST(ArcBudget, OfTheHeightsAddsUpToThatOfTheIntersection) {
  Measurement measurement = test::paperMeasurement();
  measurement.sigmaDistance = 1;
  const SessionFit fit = fitSession(measurement);
  ASSERT_EQ(fit.budgets.size(), 2u);
  const std::vector<BudgetEntry>&upper = fit.budgets[0].y, &lower = fit.budgets[1].y;
  const std::vector<BudgetEntry>& difference = fit.intersection->budget;
  ASSERT_EQ(upper.size(), difference.size());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    EXPECT_EQ(upper[i].source, difference[i].source);
    const bool distance = difference[i].source == UncertaintySource::Distance;
    const double expected =
        distance ? (upper[i].sigma + lower[i].sigma) / 2 : std::hypot(upper[i].sigma, lower[i].sigma) / 2;
    EXPECT_NEAR(difference[i].sigma, expected, 1e-9 * expected) << i;
  }
  EXPECT_NEAR(combined(fit.budgets[0].radius), fit.sigmas[0].radius, 1e-15);
}

}  // namespace
}  // namespace alidade
