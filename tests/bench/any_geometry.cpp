#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/visibility.h"
#include "core/effects/catalogue.h"
#include "core/session/measurement.h"
#include "core/simulation/trial_series.h"
#include "core/simulation/trial_summary.h"
#include "tests/support/drawn_plan.h"

// Results in plans outside the named tests: 3 to 500 places over 20° to 350° of arc, one to three rounds, one
// face, both or alternating faces, with or without slider, L from 0.5 to 50 m, R from 50 mm to 5 m, σ from
// 0.1″ to 60″. Half of the sessions have no effect, half one catalogued effect of one to four plausible
// sizes. Counts false alarms, right answers, and how often Δd ± U (stated 95 %) covers the truth. If nothing
// is wrong, Δd is that of the fit; if causes are named, Δd includes them.
//
//   alidade_any_geometry [SESSIONS [SEED [THREADS]]]

namespace {

using namespace alidade;
using namespace alidade::test;

const Effect& drawnEffect(std::mt19937_64& random, bool slider) {
  const auto effects = effectCatalogue();
  while (true) {
    const auto index = drawnCount(random, 0, static_cast<int>(effects.size()) - 1);
    const Effect& effect = effects[static_cast<std::size_t>(index)];
    if (effect.id != "vertical_angle_relation" && (slider || !effect.id.starts_with("slider"))) return effect;
  }
}

/// Adds an effect in a random direction.
void putEffect(std::mt19937_64& random, const Effect& effect, Truth& truth) {
  const double size = std::uniform_real_distribution<double>(1, 4)(random),
               angle = std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random);
  const auto& parameters = effect.parameters;
  if (parameters.size() == 1)
    truth.effects = {{parameters[0].term, (std::cos(angle) < 0 ? -size : size) * parameters[0].plausible}};
  else
    truth.effects = {{parameters[0].term, size * std::cos(angle) * parameters[0].plausible},
                     {parameters[1].term, size * std::sin(angle) * parameters[1].plausible}};
}

/// A trial case, drawn again until its readings determine both arcs.
Result<TrialCase> drawnCase(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  while (true) {
    DrawnPlan plan = drawnPlan(random, 500, seed);
    const bool isQuiet = drawnChance(random, 0.5);
    const Effect& effect = drawnEffect(random, plan.protocol.slider);
    if (!isQuiet) putEffect(random, effect, plan.truth);
    const Result<Session> session = simulate(plan.protocol, plan.truth, seed),
                          perfect = simulateWithoutNoise(plan.protocol, plan.truth, seed);
    if (!session || !perfect) continue;
    const auto measurement = examine(*session).measurement;
    if (!measurement || !fitSession(*measurement).intersection) continue;
    std::optional<Visibility> shown;
    if (!isQuiet)
      if (const auto found = visibilityOf(*examine(*perfect).measurement, std::string(effect.id)))
        shown = *found;
    return TrialCase{*session, sealed(std::to_string(seed), plan.truth, shown)};
  }
}

/// How often Δd ± U, fit only, covers the truth of sessions without an effect.
Tally coveredAsModelled(std::size_t count, std::uint64_t seed) {
  Tally covered;
  for (std::size_t i = 0; i < count; ++i) {
    const Result<TrialCase> one = drawnCase(seed + i);
    if (!one || one->seal.kind != "none") continue;
    const auto intersection = fitSession(*examine(one->session).measurement).intersection;
    if (intersection)
      covered.add(std::abs(intersection->value - one->seal.intersection) <= intersection->expanded);
  }
  return covered;
}

void print(const char* what, const Tally& tally) {
  std::printf("%-34s %6zu of %6zu\n", what, tally.hits, tally.count);
}

}  // namespace

int main(int argc, char** argv) {
  TrialSeriesOptions options;
  options.count = argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 2000;
  const auto seed = argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 6100000;
  if (argc > 3) options.threads = static_cast<unsigned>(std::atoi(argv[3]));
  const auto trials = scoreTrials(options, [&](std::size_t i) { return drawnCase(seed + i); });
  if (!trials) {
    std::fprintf(stderr, "%s\n", trials.problem().text().c_str());
    return 1;
  }
  const TrialSummary summary = summarise(*trials);
  for (const auto& [kind, tally] : summary.right)
    print(("right: " + std::string(nameOf(kind))).c_str(), tally);
  print("false alarms", summary.falseAlarms);
  print("covered with the causes", summary.covered);
  print("back to noise", summary.backToNoise);
  print("covered as modelled, nothing wrong", coveredAsModelled(options.count, seed));
  return 0;
}
