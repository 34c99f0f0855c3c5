#include "core/effects/known_sizes.h"

#include <algorithm>
#include <cmath>

namespace alidade {

bool hasSizes(const Effect& effect) {
  return effect.response != Response::AllOrNothing;
}

namespace {

const EffectParameter* parameterOf(const Effect* of, std::string_view parameter, std::string_view unit) {
  if (!of || !hasSizes(*of)) return nullptr;
  const bool isOnly = of->parameters.size() == 1 && parameter.empty();
  const auto found = std::ranges::find_if(of->parameters, [&](const EffectParameter& each) {
    return (isOnly || each.name == parameter) && each.unit == unit;
  });
  return found == of->parameters.end() ? nullptr : &*found;
}

}  // namespace

const EffectParameter* findParameter(std::string_view effect, std::string_view parameter,
                                     std::string_view unit) {
  return parameterOf(effectById(effect), parameter, unit);
}

const EffectParameter* findParameter(const Measurement& measurement, const KnownNumber& known) {
  return parameterOf(effectById(known.effect, measurement), known.parameter, known.unit);
}

std::optional<KnownPrior> knownOf(const Measurement& measurement, const EffectParameter& parameter) {
  const double unit = modelUnitsPer(parameter.unit);
  KnownPrior prior;
  double weights = 0;
  for (const KnownNumber& known : measurement.known) {
    const EffectParameter* found = findParameter(measurement, known);
    if (!found || found->term != parameter.term) continue;
    const double weight = std::pow(known.sigma * unit, -2);
    weights += weight;
    prior.value += (known.value * unit - prior.value) * weight / weights;
    prior.staleChance = std::max(prior.staleChance, known.staleChance);
    prior.date = std::max(prior.date, known.date);
    if (!known.from.empty()) prior.from += (prior.from.empty() ? "" : "; ") + known.from;
  }
  if (!(weights > 0)) return std::nullopt;
  prior.sigma = 1 / std::sqrt(weights);
  return prior;
}

std::optional<std::vector<KnownPrior>> knownOf(const Measurement& measurement, const Effect& effect) {
  std::vector<KnownPrior> priors;
  for (const EffectParameter& parameter : effect.parameters) {
    std::optional<KnownPrior> prior = knownOf(measurement, parameter);
    if (!prior) return std::nullopt;
    priors.push_back(*std::move(prior));
  }
  return priors;
}

double staleChanceOf(const Measurement& measurement, const Effect& effect) {
  double chance = 0;
  for (const EffectParameter& parameter : effect.parameters)
    if (const auto known = knownOf(measurement, parameter)) chance = std::max(chance, known->staleChance);
  return chance;
}

bool isAnythingKnown(const Measurement& measurement) {
  return std::ranges::any_of(measurement.known, [&](const KnownNumber& known) {
    return findParameter(measurement, known) != nullptr;
  });
}

}  // namespace alidade
