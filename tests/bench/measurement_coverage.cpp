#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/random_source.h"
#include "core/diagnosis/diagnose.h"
#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/drawn_plan.h"

// How often Δd ± U covers the true Δd, fit only and measured. The sessions have every effect of the
// catalogue, drawn about zero with one, a half or two plausible sizes, or no effect, or a single one. Others
// have three times the stated noise and zeros without a stated σ. Every effect and that noise are also tried
// with zeros sighted in both faces, before and after. Plans are the named ones, and plans and set-ups drawn
// for each session. Stated coverage 95 %.
//
//   alidade_measurement_coverage [SESSIONS [SEED [ROWS]]]     only rows with ROWS in their names

namespace {

using namespace alidade;

struct Row {
  std::string name;
  double sizes = 1;
  std::string_view only = {};  ///< id of the only effect; empty: every one
  double noise = 1;
  bool zerosInFull = false;
};

/// The plan with its truth; drawn if `protocol` is null.
test::DrawnPlan planOf(const Protocol* protocol, std::uint64_t seed) {
  constexpr int mostPoints = 60;
  if (protocol) return {*protocol, drawTruth(seed)};
  std::mt19937_64 random(seed);
  return test::drawnPlan(random, mostPoints, seed);
}

void putEffects(Truth& truth, const Row& row, const Protocol& protocol, std::uint64_t seed) {
  constexpr std::uint64_t stream = 55;  // separate from those of guideway and noise
  truth.noiseFactor = row.noise;
  truth.sightsZerosInFull = row.zerosInFull;
  if (row.noise != 1)  // the zeros then scatter like the circles, without a stated σ
    truth.sigmaZero = std::min(truth.sigmaHorizontal, truth.sigmaVertical) * row.noise;
  RandomSource random(seed, stream);
  for (const Effect& effect : effectCatalogue()) {
    if (effect.response == Response::AllOrNothing || (!protocol.slider && effect.id.starts_with("slider")))
      continue;
    for (const EffectParameter& parameter : effect.parameters) {
      const double size = row.sizes * random.normal() * parameter.plausible;
      if (row.only.empty() || row.only == effect.id) truth.effects.push_back({parameter.term, size});
    }
  }
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void print(const Row& row, const Protocol* protocol, int sessions, std::uint64_t seed) {
  int ofFit = 0, asMeasured = 0, count = 0;
  std::vector<double> expandedOfFit, expanded;
  for (int i = 0; i < sessions; ++i) {
    const auto own = seed + static_cast<std::uint64_t>(i);
    auto [plan, truth] = planOf(protocol, own);
    putEffects(truth, row, plan, own);
    Result<Session> simulated = simulate(plan, truth, own);
    if (!simulated) continue;
    Session session = *simulated;
    if (row.noise != 1) session.instrument.sigmaZeroArcsec.clear();
    const Measurement measurement = *examine(session).measurement;
    const SessionFit fit = fitSession(measurement);
    const auto diagnosis = diagnose(measurement, fit);
    if (!fit.intersection || !diagnosis || !diagnosis->measured) continue;
    const IntersectionEstimate& measured = diagnosis->measured->estimate;
    ++count;
    ofFit += std::abs(fit.intersection->value - truth.intersection) <= fit.intersection->expanded;
    asMeasured += std::abs(measured.value - truth.intersection) <= measured.expanded;
    expandedOfFit.push_back(fit.intersection->expanded);
    expanded.push_back(measured.expanded);
  }
  const double percent = 100.0 / std::max(count, 1);
  std::printf("%-32s %-13s %6d  %6.1f %% %7.3f mm  %6.1f %% %7.3f mm\n", row.name.c_str(),
              protocol ? protocol->name.c_str() : "drawn anew", count, ofFit * percent, median(expandedOfFit),
              asMeasured * percent, median(expanded));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 500;
  const auto seed = argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1;
  std::vector<Row> rows{
      {.name = "every effect, 1 sigma"},
      {.name = "every effect, 1/2 sigma", .sizes = 0.5},
      {.name = "every effect, 2 sigma", .sizes = 2},
      {.name = "none", .sizes = 0},
      {.name = "noise 3 times, zeros unstated", .sizes = 0, .noise = 3},
      {.name = "every effect, zeros in full", .zerosInFull = true},
      {.name = "noise 3 times, zeros in full", .sizes = 0, .noise = 3, .zerosInFull = true}};
  for (const Effect& effect : effectCatalogue())
    if (effect.response != Response::AllOrNothing)
      rows.push_back({.name = std::string(effect.id), .only = effect.id});
  std::printf("%-32s %-13s %6s  %19s  %19s\n", "what is there", "plan", "count", "the fit alone, U",
              "as measured, U");
  for (const Row& row : rows) {
    if (argc > 3 && row.name.find(argv[3]) == std::string::npos) continue;
    for (const Protocol& protocol : namedProtocols()) print(row, &protocol, sessions, seed);
    print(row, nullptr, sessions, seed);
  }
  return 0;
}
