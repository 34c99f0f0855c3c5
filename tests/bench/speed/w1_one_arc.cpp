#include <benchmark/benchmark.h>

#include "core/adjustment/arc/arc_fit.h"
#include "tests/bench/speed/answers.h"
#include "tests/bench/speed/measurements.h"
#include "tests/bench/speed/readings.h"

// W1: one arc of 17 points, with its covariance.

namespace alidade::bench {
namespace {

void fastFit(benchmark::State& state) {
  const ArcSetup setup = usualSetup();
  const auto a = shortArcs().horizontal(0, pointsOfArc), e = shortArcs().vertical(0, pointsOfArc);
  std::optional<FastArcFit> fit;
  for (auto _ : state) {
    fit = fitArcFast(setup, a, e);
    benchmark::DoNotOptimize(fit);
  }
  if (fit) answer(state, fit->circle);
}
BENCHMARK(fastFit)->Name("W1/alidade");

/// Includes the checks of the geometry, the residuals and the confirmation by the general equations.
void wholeFit(benchmark::State& state) {
  const Measurement measurement = usualMeasurement(1);
  for (auto _ : state) {
    const auto fit = fitArc(measurement, measurement.arcs.front());
    benchmark::DoNotOptimize(fit);
  }
  const auto fit = fitArc(measurement, measurement.arcs.front());
  if (fit) answer(state, fit->circle);
}
BENCHMARK(wholeFit)->Name("W1/alidade fitArc");

}  // namespace
}  // namespace alidade::bench
