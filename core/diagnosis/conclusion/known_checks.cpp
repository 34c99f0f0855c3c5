#include "core/diagnosis/conclusion/known_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/square.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

void fillSeen(KnownCheck& check, const EstimatedTerm& term, const JointFit& fit, double unit) {
  const std::size_t i = fit.indexOf(term.term);
  const double variance = fit.cofactor(i, i), ofKnown = variance / square(term.priorSigma);
  if (!(ofKnown < thresholds.ofPriorOnly)) return;
  check.isSeen = true;
  check.value = (fit.values[i] - ofKnown * term.priorValue) / (1 - ofKnown) / unit;
  check.sigma = std::sqrt(variance / (1 - ofKnown)) / unit;
}

}  // namespace

std::vector<KnownCheck> knownChecks(const Inquiry& inquiry, const Answer& answer) {
  const GapModel& after = answer.after;
  std::vector<KnownCheck> checks;
  for (const Effect* effect : effectsOf(*after.measurement))
    for (const EffectParameter& parameter : effect->parameters) {
      const std::optional<KnownPrior> known = knownOf(*after.measurement, parameter);
      const auto term = std::ranges::find(after.options.terms, parameter.term, &EstimatedTerm::term);
      if (!known || term == after.options.terms.end()) continue;
      const double unit = modelUnitsPer(parameter.unit);
      KnownCheck check{.effect = std::string(effect->id),
                       .name = std::string(parameter.name),
                       .unit = std::string(parameter.unit),
                       .known = known->value / unit,
                       .sigmaKnown = known->sigma / unit,
                       .from = known->from,
                       .date = known->date,
                       .staleChance = inquiry.probabilityOf(effect->id)};
      fillSeen(check, *term, *after.fit, unit);
      checks.push_back(std::move(check));
    }
  return checks;
}

}  // namespace alidade
