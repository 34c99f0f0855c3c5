#include "core/adjustment/monte_carlo/refit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/session/session_file.h"
#include "tests/support/paper_table.h"
#include "tests/support/trials.h"

// The three refits of a draw differ only in speed.

namespace alidade {
namespace {

constexpr std::size_t draws = 200;

/// The largest difference of a centre's coordinate over the draws, in its σ. The general fit itself is
/// accurate to a millionth of it.
double differenceOf(Refit& one, Refit& other, const RefitTask& task) {
  std::vector<Draw> drawn(draws);
  for (std::size_t i = 0; i < draws; ++i) task.plan.drawInto(drawn[i], 3, i);
  std::vector<double> found(draws * task.centres()), expected = found;
  one.refit(drawn, found);
  other.refit(drawn, expected);
  double greatest = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t centre = i % task.centres();
    const ArcSigma& sigma = task.fit.sigmas[centre / 2];
    const double difference = std::abs(found[i] - expected[i]) / (centre % 2 == 0 ? sigma.x : sigma.y);
    greatest = std::isfinite(difference) ? std::max(greatest, difference) : 1e9;
  }
  return greatest;
}

Measurement sample(const std::string& name) {
  return *examine(*loadSession(std::string(ALIDADE_SAMPLES_DIR) + "/" + name)).measurement;
}

/// A session with every kind of uncertainty.
Measurement everything() {
  Measurement measurement = test::trialMeasurement("paper-slider");
  measurement.effects = {"collimation", "vertical_drift"};
  measurement.radiusModel = RadiusModel::Known;
  measurement.sigmaRadius = 0.1;
  measurement.sigmaDistance = 1;
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(2);
  return measurement;
}

TEST(Refit, OfArcsApartIsTheGeneralOne) {
  for (Measurement measurement : {test::paperMeasurement(), sample("two-faces.alidade")}) {
    measurement.effects.clear();
    measurement.sigmaDistance = 2;
    measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(3);
    const SessionFit fit = fitSession(measurement);
    const DrawPlan plan(measurement, fit.noise);
    const RefitTask task{measurement, fit, plan};
    const auto arcs = arcsRefit(task);
    ASSERT_TRUE(arcs);
    EXPECT_LT(differenceOf(*arcs, *generalRefit(task), task), 1e-5);
  }
}

TEST(Refit, OfArcsApartIsNotForWhatTheyShare) {
  const Measurement whole = everything();
  const SessionFit fit = fitSession(whole);
  const DrawPlan plan(whole, fit.noise);
  EXPECT_FALSE(arcsRefit({whole, fit, plan}));
}

TEST(Refit, ByExpansionIsTheGeneralOne) {
  Measurement paper = test::paperMeasurement();
  paper.sigmaDistance = 2;
  Measurement common = everything();
  common.radiusModel = RadiusModel::Common;
  for (const Measurement& measurement : {paper, sample("two-faces.alidade"), everything(), common}) {
    const SessionFit fit = fitSession(measurement);
    const DrawPlan plan(measurement, fit.noise);
    const RefitTask task{measurement, fit, plan};
    const auto model = expandedModel(task);
    ASSERT_TRUE(model);
    EXPECT_LT(differenceOf(*expandedRefit(task, model), *generalRefit(task), task), 2e-4);
  }
}

// The result of a draw is independent of the draws processed with it.
TEST(Refit, ByExpansionTakesDrawsOneByOne) {
  const Measurement measurement = sample("two-faces.alidade");
  const SessionFit fit = fitSession(measurement);
  const DrawPlan plan(measurement, fit.noise);
  const RefitTask task{measurement, fit, plan};
  const auto refit = expandedRefit(task, expandedModel(task));
  std::vector<Draw> drawn(11);
  for (std::size_t i = 0; i < drawn.size(); ++i) plan.drawInto(drawn[i], 1, i);
  std::vector<double> together(drawn.size() * task.centres()), alone(task.centres());
  refit->refit(drawn, together);
  refit->refit(std::span(drawn).last(1), alone);
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(alone[i], together[together.size() - alone.size() + i], 1e-6);
}

TEST(MonteCarloRefits, IsTheSameOnAnyNumberOfThreads) {
  const Measurement measurement = sample("two-faces.alidade");
  const SessionFit fit = fitSession(measurement);
  const auto one = propagateDistributions(measurement, fit, {.draws = 3000, .threads = 1}),
             three = propagateDistributions(measurement, fit, {.draws = 3000, .threads = 3});
  EXPECT_EQ(one->intersection->low, three->intersection->low);
  EXPECT_EQ(one->intersection->sigma, three->intersection->sigma);
}

TEST(MonteCarlo, TellsWhereTheNumberOfDrawsIsLeftOpen) {
  for (const Measurement& measurement : {test::paperMeasurement(), sample("two-faces.alidade")}) {
    const auto check = propagateDistributions(measurement, fitSession(measurement), {});
    EXPECT_EQ(check->linear, LinearPropagation::Validated);
    EXPECT_LE(3 * check->endpointSigma, check->tolerance);
    EXPECT_GE(check->draws, 20000u);
  }
}

}  // namespace
}  // namespace alidade
