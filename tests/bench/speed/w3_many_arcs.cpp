#include <benchmark/benchmark.h>

#include "tests/bench/speed/answers.h"
#include "tests/bench/speed/readings.h"

// W3: 100 000 arcs of 17 points, on one thread and on two.

namespace alidade::bench {
namespace {

void fastFits(benchmark::State& state) {
  const ArcSetup setup = usualSetup();
  const ArcReadings& readings = shortArcs();
  std::vector<std::optional<FastArcFit>> fits(manyArcs);
  for (auto _ : state) {
    fitArcsFast(setup, readings.a, readings.e, fits, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(fits.data());
  }
  state.counters["each"] = static_cast<double>(manyArcs);
  MeanCircle mean;
  for (std::size_t i = 0; i < peerArcs; ++i)
    if (fits[i]) mean.add(fits[i]->circle);
  answer(state, mean.value());
}
BENCHMARK(fastFits)->Name("W3/alidade")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alidade::bench
