#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/base/statistics.h"
#include "tests/bench/speed/measurements.h"
#include "tests/bench/speed/readings.h"

// W2: both arcs of a session, 17 points each, to Δd, U and all residuals. U is that of the readings, scaled
// by their scatter; k is Student's quantile, calculated once for the 28 degrees of freedom.

namespace alidade::bench {
namespace {

struct Outcome {
  double value = 0, expanded = 0;
};

struct Residuals {
  std::array<double, pointsOfArc> horizontal{}, vertical{};
};

Outcome outcomeOf(const FastArcFit& upper, const FastArcFit& lower, double factor, double degreesOfFreedom) {
  const double scatter = (upper.chiSquare + lower.chiSquare) / degreesOfFreedom;
  const double variance = scatter * (upper.cofactor[1][1] + lower.cofactor[1][1]) / 4;
  return {(upper.circle.y - lower.circle.y) / 2, factor * std::sqrt(variance)};
}

void answerWith(benchmark::State& state, const Outcome& outcome) {
  state.counters["intersection"] = outcome.value;
  state.counters["U"] = outcome.expanded;
}

void fastFits(benchmark::State& state) {
  const ArcSetup setup = usualSetup();
  constexpr double degreesOfFreedom = 2 * (static_cast<double>(pointsOfArc) - 3);
  const double factor = coverageFactor(0.95, degreesOfFreedom);
  std::array<Residuals, 2> residuals;
  const auto fit = [&](std::size_t arc) {
    return fitArcFast(setup, shortArcs().horizontal(arc * pointsOfArc, pointsOfArc),
                      shortArcs().vertical(arc * pointsOfArc, pointsOfArc), {},
                      {residuals[arc].horizontal, residuals[arc].vertical});
  };
  Outcome outcome;
  for (auto _ : state) {
    const auto upper = fit(0), lower = fit(1);
    if (!upper || !lower) return state.SkipWithError("refused");
    outcome = outcomeOf(*upper, *lower, factor, degreesOfFreedom);
    benchmark::DoNotOptimize(outcome);
    benchmark::DoNotOptimize(residuals);
  }
  answerWith(state, outcome);
}
BENCHMARK(fastFits)->Name("W2/alidade");

/// All results for a session: budgets, reliability, findings.
void wholeFit(benchmark::State& state) {
  const Measurement measurement = usualMeasurement(2);
  Outcome outcome;
  for (auto _ : state) {
    const SessionFit fit = fitSession(measurement);
    outcome = {fit.intersection->value, fit.intersection->expanded};
    benchmark::DoNotOptimize(outcome);
  }
  answerWith(state, outcome);
}
BENCHMARK(wholeFit)->Name("W2/alidade fitSession");

}  // namespace
}  // namespace alidade::bench
