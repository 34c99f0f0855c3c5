#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "tests/support/perfect_session.h"

// Tests whether every uncertain quantity is drawn, and where the intervals end.

namespace alidade {
namespace {

/// Both positions, Δd 0.5 mm, without noise: the stated σ then count as known.
Measurement perfect(int places, double spanDegrees) {
  Measurement measurement = test::usualMeasurement();
  for (const int axisDeg : {0, 180})
    measurement.arcs.push_back(test::perfectArc(measurement, {0, axisDeg == 0 ? 0.5 : -0.5, 400},
                                                test::spread(places, spanDegrees, axisDeg == 0 ? 90 : 270),
                                                axisDeg));
  return measurement;
}

double sigmaOfDraws(const Measurement& measurement, std::size_t draws) {
  const SessionFit fit = fitSession(measurement);
  return propagateDistributions(measurement, fit, {.draws = draws}).value().intersection.value().sigma;
}

// A slider of 20″ is about as accurate along the arc as circles of 2″. It contributes more than a third of
// the variance of Δd (∂Δd/∂reading · σ of every reading, summed). σ of 1000 draws is known to 2.2 %.
TEST(MonteCarloDraws, TakeTheSlidersNoise) {
  Measurement measurement = perfect(17, 160);
  measurement.sigmaSlider = Angle::fromArcseconds(20);
  for (ArcMeasurement& arc : measurement.arcs)  // s is φ at 0°, −φ at 180°, where the places go backwards
    for (Sighting& sighting : arc.sightings)
      sighting.slider =
          Angle::fromDegrees(arc.axisDeg == 0 ? 10 * sighting.point : 180 - 10 * sighting.point);
  const SessionFit fit = fitSession(measurement);
  double variance = 0, ofSlider = 0;
  for (const AdjustedReading& reading : fit.joint.readings) {
    const double share = std::pow(reading.perReading * reading.sigma, 2);
    variance += share;
    if (reading.kind == ReadingKind::Slider) ofSlider += share;
  }
  ASSERT_GT(ofSlider, variance / 3);
  EXPECT_NEAR(sigmaOfDraws(measurement, 1000), std::sqrt(variance), 0.1 * std::sqrt(variance));
}

// On a short arc of 15° the readings hardly determine R compared with a known one of 0.1 mm. A radius error δ
// moves the centre along the arc's middle by −δ Σ sin φ/Σ sin² φ, in opposite directions for the two. So Δd
// errs by that much, and by some 0.007 mm from the readings. σ of 1000 draws is known to 2.2 %.
TEST(MonteCarloDraws, TakeTheKnownRadius) {
  Measurement measurement = perfect(5, 15);
  measurement.radiusModel = RadiusModel::Known;
  measurement.sigmaRadius = 0.1;
  double sines = 0, squares = 0;
  for (const double phi : test::spread(5, 15)) {
    sines += std::sin(phi);
    squares += std::pow(std::sin(phi), 2);
  }
  const double expected = std::hypot(0.1 * sines / squares, 0.007);
  EXPECT_NEAR(sigmaOfDraws(measurement, 1000), expected, 0.1 * expected);
}

// JCGM 101, 7.7.2: of M = 100 draws the 95 % interval goes from the 3rd to the 98th in order of size, since q
// = pM = 95 and r is the whole part of (M − q + 1)/2 = 3. The 90 % interval goes from the 5th to the 95th, as
// r = (M − q)/2 is whole. For any distribution the average share below the r-th draw is r/(M + 1), with a
// scatter of √(r(M + 1 − r)/(M + 2))/(M + 1), 0.022 for the 5th: over 400 seeds that is 0.11 ranks. Three
// places on an arc are linear in their readings: Δd is normal with the budget's σ.
TEST(MonteCarloDraws, IntervalEndsAtTheDrawsOfTheGuide) {
  struct Interval {
    double coverage, low, high;
  };
  for (const auto& [coverage, first, last] : {Interval{0.95, 3, 98}, Interval{0.9, 5, 95}}) {
    Measurement measurement = perfect(3, 160);
    measurement.coverage = coverage;
    const SessionFit fit = fitSession(measurement);
    constexpr int seeds = 400;
    double low = 0, high = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Spread spread =
          *propagateDistributions(measurement, fit, {.draws = 100, .seed = seed})->intersection;
      const auto below = [&](double value) {
        return std::erfc((fit.intersection->value - value) / fit.intersection->sigma / std::numbers::sqrt2) /
               2;
      };
      low += below(spread.low);
      high += below(spread.high);
    }
    EXPECT_NEAR(101 * low / seeds, first, 0.4) << coverage;
    EXPECT_NEAR(101 * high / seeds, last, 0.4) << coverage;
  }
}

}  // namespace
}  // namespace alidade
