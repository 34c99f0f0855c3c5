#include <benchmark/benchmark.h>

#include <string>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/session/session_file.h"

// W11: checks the linear budget by a million draws, on as many threads as the machine has. The sessions are
// Table I, and one of 72 rows in two faces with two estimated effects.

namespace alidade::bench {
namespace {

void draw(benchmark::State& state, const std::string& sample) {
  const Result<Session> session = loadSession(std::string(ALIDADE_SAMPLES_DIR) + "/" + sample);
  if (!session) return state.SkipWithError("no sample");
  const Measurement measurement = examine(*session).measurement.value();
  const SessionFit fit = fitSession(measurement);
  std::optional<MonteCarlo> check;
  for (auto _ : state) {
    check = propagateDistributions(measurement, fit, {.draws = 1000000});
    benchmark::DoNotOptimize(check);
  }
  if (!check || !check->intersection) return;
  state.counters["low"] = check->intersection->low;
  state.counters["high"] = check->intersection->high;
}

void tableOne(benchmark::State& state) {
  draw(state, "paper-table-1.alidade");
}
BENCHMARK(tableOne)->Name("W11/alidade")->UseRealTime()->Iterations(1)->Unit(benchmark::kMillisecond);

void twoFaces(benchmark::State& state) {
  draw(state, "two-faces.alidade");
}
BENCHMARK(twoFaces)
    ->Name("W11/alidade two faces")
    ->UseRealTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alidade::bench
