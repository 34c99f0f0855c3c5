#include <benchmark/benchmark.h>

#include "core/adjustment/joint/reliability.h"
#include "core/adjustment/result/session_fit.h"
#include "tests/bench/speed/measurements.h"

// W6: the general fit of the protocol `full`: 136 rows in two faces and two rounds, slider readings,
// covariance, redundancies and the smallest detectable error of every reading.

namespace alidade::bench {
namespace {

double smallestDetectable(const JointFit& fit) {
  const Detection detection = detectionIn(fit, 1);
  double sum = 0;
  for (const AdjustedReading& reading : fit.readings) sum += reliabilityOf(reading, detection).influence;
  return sum;
}

void jointFit(benchmark::State& state) {
  const Measurement measurement = fullMeasurement();
  std::vector<Circle> starts;
  for (const ArcFit& arc : fitSession(measurement).arcs) starts.push_back(arc.circle);
  for (Circle& start : starts) start.radius += 0.01;  // start away from the result
  for (auto _ : state) {
    const JointFit fit = fitJointly(measurement, starts);
    benchmark::DoNotOptimize(smallestDetectable(fit));
  }
}
BENCHMARK(jointFit)->Name("W6/alidade")->Unit(benchmark::kMicrosecond);

/// Covers everything from the readings to the findings, including the fits of the single arcs.
void wholeFit(benchmark::State& state) {
  const Measurement measurement = fullMeasurement();
  for (auto _ : state) {
    const SessionFit fit = fitSession(measurement);
    benchmark::DoNotOptimize(smallestDetectable(fit.joint));
  }
}
BENCHMARK(wholeFit)->Name("W6/alidade fitSession")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace alidade::bench
