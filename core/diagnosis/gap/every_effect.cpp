#include "core/diagnosis/gap/every_effect.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/effects/catalogue.h"
#include "core/effects/known_sizes.h"
#include "core/observation/visits.h"

namespace alidade {

namespace {

bool isOfSlider(ErrorTerm term) {
  return term == ErrorTerm::SliderScale || term == ErrorTerm::SliderSine;
}

}  // namespace

std::vector<EstimatedTerm> everyEffect(const Measurement& measurement) {
  const bool hasSlider = std::ranges::any_of(measurement.arcs, hasSliderReadings);
  std::vector<EstimatedTerm> terms;
  for (const Effect& effect : effectCatalogue()) {
    if (!hasSizes(effect)) continue;
    for (const EffectParameter& parameter : effect.parameters) {
      if (!hasSlider && isOfSlider(parameter.term)) continue;
      const std::optional<KnownPrior> known = knownOf(measurement, parameter);
      terms.push_back(known ? EstimatedTerm{parameter.term, known->sigma, known->value, known->value}
                            : EstimatedTerm{parameter.term, plausibleSize(parameter)});
    }
  }
  return terms;
}

std::vector<EstimatedTerm> knownTerms(const Measurement& measurement) {
  std::vector<EstimatedTerm> terms = everyEffect(measurement);
  std::erase_if(terms, [&](const EstimatedTerm& term) {
    const auto& parameters = effectOf(term.term)->parameters;
    return !knownOf(measurement, *std::ranges::find(parameters, term.term, &EffectParameter::term));
  });
  return terms;
}

GapModel withKnownSizes(GapModel model) {
  const std::vector<EstimatedTerm> known = knownTerms(*model.measurement);
  if (known.empty()) return model;
  for (const EstimatedTerm& term : known) {
    const auto there = std::ranges::find(model.options.terms, term.term, &EstimatedTerm::term);
    if (there == model.options.terms.end())
      model.options.terms.push_back(term);
    else
      *there = term;
  }
  model.refit();
  return model;
}

bool isLarge(const Measurement& measurement) {
  constexpr std::size_t many = 5000;
  return measurement.rows > many;
}

double EffectScales::of(const Effect& effect) const {
  switch (effect.source) {
    case ErrorSource::Guideway:
      return guideway;
    case ErrorSource::Instrument:
      return instrument;
    default:
      return time;
  }
}

const std::vector<PossibleScales>& possibleScales() {
  static const std::vector<PossibleScales> all = [] {
    constexpr std::array scales{0.03, 0.3, 1.0, 3.0};
    constexpr double alike = 0.5, count = scales.size();
    std::vector<PossibleScales> possible;
    for (const double scale : scales) possible.push_back({{scale, scale, scale}, alike / count});
    for (const double guideway : scales)
      for (const double instrument : scales)
        for (const double time : scales)
          possible.push_back({{guideway, instrument, time}, (1 - alike) / (count * count * count)});
    return possible;
  }();
  return all;
}

GapModel withEveryEffect(GapModel model, const EffectScales& scales) {
  const std::vector<std::string>& own = model.measurement->effects;
  const std::vector<EstimatedTerm> known = knownTerms(*model.measurement);
  for (EstimatedTerm term : everyEffect(*model.measurement)) {
    if (std::ranges::find(known, term.term, &EstimatedTerm::term) == known.end())
      term.priorSigma *= scales.of(*effectOf(term.term));
    const auto there = std::ranges::find(model.options.terms, term.term, &EstimatedTerm::term);
    if (there == model.options.terms.end())
      model.options.terms.push_back(term);
    else if (std::ranges::find(own, effectOf(term.term)->id) == own.end())
      there->priorSigma = std::max(there->priorSigma, term.priorSigma);
  }
  model.refit();
  return model;
}

}  // namespace alidade
