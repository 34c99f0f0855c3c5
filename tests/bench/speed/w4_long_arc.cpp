#include <benchmark/benchmark.h>

#include "tests/bench/speed/answers.h"
#include "tests/bench/speed/readings.h"

// W4: one arc of a million points.

namespace alidade::bench {
namespace {

void fastFit(benchmark::State& state) {
  const ArcSetup setup = usualSetup();
  const ArcReadings& readings = longArc();
  std::optional<FastArcFit> fit;
  for (auto _ : state) {
    fit = fitArcFast(setup, readings.a, readings.e);
    benchmark::DoNotOptimize(fit);
  }
  state.counters["each"] = static_cast<double>(manyPoints);
  if (fit) answer(state, fit->circle);
}
BENCHMARK(fastFit)->Name("W4/alidade")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alidade::bench
