#include "core/diagnosis/gap/every_effect.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/effects/catalogue.h"
#include "core/effects/known_sizes.h"
#include "core/observation/visits.h"

namespace alidade {

namespace {

/// Returns the prior of the tilt about x if the session does not state whether the plane is vertical or
/// square to an inclined zero. Both cases are equally probable.
std::optional<Prior> tiltInDoubt(const Measurement& measurement) {
  constexpr double level = 0.1 * std::numbers::pi / 180;  // rad; a smaller tilt affects neither the readings
                                                          // nor Δd
  if (measurement.isPlaneStated || measurement.arcs.empty()) return std::nullopt;
  const double elevation = measurement.arcs.front().zeroElevation.radians();
  if (std::abs(elevation) < level) return std::nullopt;
  return Prior{elevation / 2, std::abs(elevation) / 2};
}

}  // namespace

std::vector<EstimatedTerm> everyEffect(const Measurement& measurement) {
  const bool hasSlider = std::ranges::any_of(measurement.arcs, hasSliderReadings);
  const std::optional<Prior> tilt = tiltInDoubt(measurement);
  std::vector<EstimatedTerm> terms;
  for (const Effect* effect : effectsOf(measurement)) {
    if (!hasSizes(*effect)) continue;
    for (const EffectParameter& parameter : effect->parameters) {
      if (!hasSlider && parameter.traits.needsSlider) continue;
      const std::optional<KnownPrior> known = knownOf(measurement, parameter);
      if (known)
        terms.push_back({parameter.term, known->sigma, known->value, known->value});
      else if (tilt && parameter.term == ErrorTerm::PlaneTiltX)
        terms.push_back(
            {parameter.term, std::hypot(plausibleSize(parameter), tilt->sigma), tilt->value, tilt->value});
      else
        terms.push_back({parameter.term, plausibleSize(parameter)});
    }
  }
  return terms;
}

std::vector<EstimatedTerm> knownTerms(const Measurement& measurement) {
  std::vector<EstimatedTerm> terms = everyEffect(measurement);
  const std::optional<Prior> tilt = tiltInDoubt(measurement);
  std::erase_if(terms, [&](const EstimatedTerm& term) {
    const auto& parameters = effectOf(term.term, measurement)->parameters;
    return !knownOf(measurement, *std::ranges::find(parameters, term.term, &EffectParameter::term)) &&
           !(tilt && term.term == ErrorTerm::PlaneTiltX);
  });
  if (tilt)
    for (EstimatedTerm& term : terms)
      if (term.term == ErrorTerm::PlaneTiltX && term.priorValue == tilt->value) term.priorSigma = tilt->sigma;
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
    constexpr std::array scales{1.0, 3.0};
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
      term.priorSigma *= scales.of(*effectOf(term.term, *model.measurement));
    const auto there = std::ranges::find(model.options.terms, term.term, &EstimatedTerm::term);
    if (there == model.options.terms.end())
      model.options.terms.push_back(term);
    else if (std::ranges::find(own, effectOf(term.term, *model.measurement)->id) == own.end())
      there->priorSigma = std::max(there->priorSigma, term.priorSigma);
  }
  model.refit();
  return model;
}

}  // namespace alidade
