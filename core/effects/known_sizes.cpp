#include "core/effects/known_sizes.h"

#include <algorithm>
#include <cmath>

namespace alidade {

const EffectParameter* parameterMeant(const KnownNumber& known) {
  const Effect* effect = effectById(known.effect);
  if (!effect || effect->response == Response::AllOrNothing) return nullptr;
  const bool isOnly = effect->parameters.size() == 1 && known.parameter.empty();
  const auto meant = std::ranges::find_if(effect->parameters, [&](const EffectParameter& parameter) {
    return (isOnly || parameter.name == known.parameter) && parameter.unit == known.unit;
  });
  return meant == effect->parameters.end() ? nullptr : &*meant;
}

std::optional<KnownPrior> knownOf(const Measurement& measurement, const EffectParameter& parameter) {
  const double unit = modelUnitsPer(parameter.unit);
  KnownPrior prior;
  double weights = 0;
  for (const KnownNumber& known : measurement.known) {
    const EffectParameter* meant = parameterMeant(known);
    if (!meant || meant->term != parameter.term) continue;
    const double weight = std::pow(known.sigma * unit, -2);
    weights += weight;
    prior.value += (known.value * unit - prior.value) * weight / weights;
    if (!known.from.empty()) prior.from += (prior.from.empty() ? "" : "; ") + known.from;
  }
  if (!(weights > 0)) return std::nullopt;
  prior.sigma = 1 / std::sqrt(weights);
  return prior;
}

}  // namespace alidade
