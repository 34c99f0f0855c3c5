#include <benchmark/benchmark.h>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/simulate.h"
#include "tests/bench/speed/measurements.h"

// W7: a whole diagnosis of the protocol `full`: 136 rows, 340 readings. It includes catalogue, jumps,
// misreadings, patterns, location, look-alikes, held-out readings and advice.

namespace alidade::bench {
namespace {

void diagnosis(benchmark::State& state, const Measurement& measurement) {
  for (auto _ : state) benchmark::DoNotOptimize(diagnose(measurement));
}

void withinNoise(benchmark::State& state) {
  diagnosis(state, fullMeasurement());
}
BENCHMARK(withinNoise)->Name("W7/alidade")->Unit(benchmark::kMillisecond);

/// With two causes, a diagnosis also includes the search, fits with the causes, held-out readings and steps.
void twoCauses(benchmark::State& state) {
  Truth truth = drawTruth(1);
  truth.effects = {{ErrorTerm::HorizontalDrift, 30}, {ErrorTerm::LobingCosine, 0.1}};
  diagnosis(state, examine(*simulate(*protocolByName("full"), truth, 1)).measurement.value());
}
BENCHMARK(twoCauses)->Name("W7/alidade two causes")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alidade::bench
