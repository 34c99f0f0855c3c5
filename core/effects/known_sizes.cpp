#include "core/effects/known_sizes.h"

#include <algorithm>
#include <cmath>

namespace alidade {

bool hasSizes(const Effect& effect) {
  return effect.response != Response::AllOrNothing;
}

const EffectParameter* parameterMeant(std::string_view effect, std::string_view parameter,
                                      std::string_view unit) {
  const Effect* of = effectById(effect);
  if (!of || !hasSizes(*of)) return nullptr;
  const bool isOnly = of->parameters.size() == 1 && parameter.empty();
  const auto meant = std::ranges::find_if(of->parameters, [&](const EffectParameter& each) {
    return (isOnly || each.name == parameter) && each.unit == unit;
  });
  return meant == of->parameters.end() ? nullptr : &*meant;
}

const EffectParameter* parameterMeant(const KnownNumber& known) {
  return parameterMeant(known.effect, known.parameter, known.unit);
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
