#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/search/explanation.h"
#include "tests/bench/speed/measurements.h"

// W5: every effect of the catalogue (17, with 29 parameters) on 34 points: from the finished fit to the
// evidence of each. A candidate is one or two columns projected off the base fit, without a separate fit.

namespace alidade::bench {
namespace {

double bestEvidence(const Leftover& leftover) {
  double best = 0;
  const SharedProducts residual(leftover, leftover.residual());
  for (const EffectComponent& effect : effectComponents(leftover, {}))
    best = std::max(best, fitAlone(residual, effect, 0).logGain);
  return best;
}

/// Records, with the time, the decrease of χ² for each effect that peers also fit, for `table.py`.
void answer(benchmark::State& state, const Leftover& leftover) {
  for (const EffectComponent& effect : effectComponents(leftover, {})) {
    const Eigen::MatrixXd gram = effect.gram();
    if (gram.trace() < 1e-6) continue;  // undetectable
    const Eigen::VectorXd products = effect.visibleColumns(leftover).transpose() * leftover.residual();
    state.counters["fall by " + std::string(effect.id())] = products.dot(gram.ldlt().solve(products));
  }
}

void candidateEffects(benchmark::State& state) {
  const Measurement measurement = usualMeasurement(2);
  const Linearised equations = linearise(measurement, fitSession(measurement).joint);
  for (auto _ : state) benchmark::DoNotOptimize(bestEvidence(Leftover(equations)));
  answer(state, Leftover(equations));
}
BENCHMARK(candidateEffects)->Name("W5/alidade")->Unit(benchmark::kMicrosecond);

/// Includes the derivatives with respect to all error terms.
void fromTheFit(benchmark::State& state) {
  const Measurement measurement = usualMeasurement(2);
  const JointFit fit = fitSession(measurement).joint;
  for (auto _ : state) benchmark::DoNotOptimize(bestEvidence(Leftover(linearise(measurement, fit))));
}
BENCHMARK(fromTheFit)->Name("W5/alidade with derivatives")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace alidade::bench
