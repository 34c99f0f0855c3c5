#include "core/adjustment/monte_carlo/monte_carlo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

MonteCarlo checked(const Measurement& measurement, const MonteCarloOptions& options) {
  return propagateDistributions(measurement, fitSession(measurement), options).value();
}

// The usual arc is nearly linear in its readings. σ of the draws is the budget's with the readings' share
// widened to Student's, √(f/(f − 2)); 4000 draws determine it to 1.1 %, and an end of the interval to
// `endpointSigma`.
TEST(MonteCarlo, AgreesWithTheLinearBudgetOfTableI) {
  const Measurement measurement = test::paperMeasurement();
  const SessionFit fit = fitSession(measurement);
  const MonteCarlo check = checked(measurement, {.draws = 4000});
  const double f = fit.noise.degreesOfFreedom;
  double variance = 0;
  for (const BudgetEntry& entry : fit.intersection->budget)
    variance += entry.sigma * entry.sigma * (entry.source == UncertaintySource::Readings ? f / (f - 2) : 1);
  ASSERT_TRUE(check.intersection);
  EXPECT_NEAR(check.intersection->sigma, std::sqrt(variance), 0.05 * std::sqrt(variance));
  EXPECT_NEAR(check.intersection->mean, fit.intersection->value, 5 * std::sqrt(variance / 4000));
  EXPECT_LT(check.lowDifference, 5 * check.endpointSigma);
  EXPECT_LT(check.highDifference, 5 * check.endpointSigma);
  EXPECT_NE(check.linear, LinearPropagation::Refuted);
  EXPECT_DOUBLE_EQ(check.tolerance, 0.005);  // σ is 0.10 mm to two digits
  ASSERT_EQ(check.centres.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(check.centres[i].y.sigma, fit.sigmas[i].y, 0.08 * fit.sigmas[i].y);
    EXPECT_NEAR(check.centres[i].x.sigma, fit.sigmas[i].x, 0.08 * fit.sigmas[i].x);
  }
}

// Slider readings, both faces and an effect with its prior use the joint fit.
TEST(MonteCarlo, DrawsWhateverTheFitTakes) {
  Measurement measurement = test::trialMeasurement("paper-slider");
  measurement.effects = {"vertical_drift"};
  measurement.radiusModel = RadiusModel::Known;
  measurement.sigmaRadius = 0.1;
  measurement.sigmaDistance = 1;
  const SessionFit fit = fitSession(measurement);
  const MonteCarlo check = checked(measurement, {.draws = 1000});
  // σ known to 2.2 % from 1000 draws; Student's width adds up to 2 %.
  EXPECT_NEAR(check.intersection->sigma, fit.intersection->sigma, 0.1 * fit.intersection->sigma);
  EXPECT_EQ(check.failed, 0u);
}

// A repeated position: one centre for each axis, and estimated zeros. σ of 4000 draws is known to 1.1 %, and
// Student's width with some 40 degrees of freedom adds 3 %.
TEST(MonteCarlo, DrawsPositionsMeasuredAgain) {
  for (const char* protocol : {"again", "full-again"}) {
    const Measurement measurement =
        test::measurementOf(*simulate(*protocolByName(protocol), drawTruth(3), 3));
    const SessionFit fit = fitSession(measurement);
    const MonteCarlo check = checked(measurement, {.draws = 4000});
    ASSERT_TRUE(check.intersection);
    EXPECT_NEAR(check.intersection->sigma, fit.intersection->sigma, 0.05 * fit.intersection->sigma);
    EXPECT_NEAR(check.intersection->mean, fit.intersection->value, 0.08 * fit.intersection->sigma);
    ASSERT_EQ(check.centres.size(), 2u) << "one for each axis";
    EXPECT_EQ(check.centres[0].axisDeg, 0);
    EXPECT_EQ(check.centres[1].axisDeg, 180);
    EXPECT_NEAR(check.centres[0].x.sigma, fit.sigmas[0].x, 0.05 * fit.sigmas[0].x);
    EXPECT_NEAR(check.centres[1].y.sigma, fit.sigmas[1].y, 0.05 * fit.sigmas[1].y);
  }
}

TEST(MonteCarlo, IsTheSameOnAnyNumberOfThreads) {
  const Measurement measurement = test::paperMeasurement();
  const MonteCarlo one = checked(measurement, {.draws = 500, .seed = 9, .threads = 1});
  const MonteCarlo three = checked(measurement, {.draws = 500, .seed = 9, .threads = 3});
  const MonteCarlo other = checked(measurement, {.draws = 500, .seed = 10, .threads = 3});
  EXPECT_EQ(one.intersection->mean, three.intersection->mean);
  EXPECT_EQ(one.intersection->high, three.intersection->high);
  EXPECT_EQ(one.centres[1].x.sigma, three.centres[1].x.sigma);
  EXPECT_NE(one.intersection->mean, other.intersection->mean);
}

// On 20° of arc a noise of 40″ makes R uncertain by a tenth, far beyond the linear range: the check has to
// say so.
TEST(MonteCarlo, RefutesTheLinearBudgetOfAPoorArc) {
  Measurement measurement = test::paperMeasurement();
  for (ArcMeasurement& arc : measurement.arcs)
    std::erase_if(arc.sightings, [](const Sighting& s) { return s.point < 8 || s.point > 10; });
  measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(40);
  const MonteCarlo check = checked(measurement, {.draws = 3000});
  EXPECT_EQ(check.linear, LinearPropagation::Refuted);
}

TEST(MonteCarlo, StopsWhenAsked) {
  const Measurement measurement = test::paperMeasurement();
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(
      propagateDistributions(measurement, fitSession(measurement), {.draws = 1000000}, source.get_token()));
}

TEST(MonteCarlo, HoldsForOnePosition) {
  Measurement measurement = test::paperMeasurement();
  measurement.arcs.pop_back();
  const MonteCarlo check = checked(measurement, {.draws = 200});
  EXPECT_FALSE(check.intersection);
  EXPECT_EQ(check.centres.size(), 1u);
  measurement.arcs[0].sightings.resize(2);
  EXPECT_FALSE(propagateDistributions(measurement, fitSession(measurement), {.draws = 200}));
}

}  // namespace
}  // namespace alidade
