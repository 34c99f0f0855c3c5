#include "core/diagnosis/observability/advice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/observability/further_terms.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/effects/cause_ids.h"
#include "core/observation/reading_ref.h"

namespace alidade {

namespace {

using Eigen::VectorXd;

/// What the cause is made of, at the size that was found.
VectorXd combinationOf(const Cause& cause, const Effect& effect) {
  VectorXd weights(static_cast<Eigen::Index>(effect.parameters.size()));
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    weights[static_cast<Eigen::Index>(p)] = cause.parameters[p].value / effect.parameters[p].plausible;
  return combinationOf(effect) * weights;
}

std::optional<Advice> separating(const Cause& cause, Measure measure, const VisibleTerms& terms) {
  const Effect* own = effectById(cause.effect);
  if (!own) return std::nullopt;
  const VectorXd combination = combinationOf(cause, *own);
  Advice advice{.measure = measure, .separates = {cause.effect}, .bySigma = lengthOf(terms, combination)};
  for (const std::string& id : cause.indistinguishableFrom) {
    const Effect* other = effectById(id);
    const double difference = other ? linearDifferenceFrom(terms, combination, *other) : 0;
    if (difference < clearlyDifferent) continue;
    advice.separates.push_back(id);
    advice.bySigma = std::min(advice.bySigma, difference);
  }
  if (advice.separates.size() < 2) return std::nullopt;
  return advice;
}

std::optional<Advice> revealing(const std::vector<Detectability>& unseen, Measure measure,
                                const VisibleTerms& terms) {
  Advice advice{.measure = measure, .ofUnseen = true};
  for (const Detectability& detectability : unseen) {
    const Effect* effect = effectById(detectability.effect);
    if (!effect) continue;
    const double visible = lengthOf(terms, combinationOf(*effect) * detectability.weights);
    if (visible < clearlyDifferent) continue;
    advice.bySigma = advice.separates.empty() ? visible : std::min(advice.bySigma, visible);
    advice.separates.emplace_back(detectability.effect);
  }
  if (advice.separates.empty()) return std::nullopt;
  return advice;
}

/// What tells a misread value from a jump that it looks like: the zero, which only a jump moves. Both
/// sightings have their noise.
std::optional<Advice> tellingFromJump(const Inquiry& inquiry, const std::vector<Cause>& causes) {
  for (const Cause& cause : causes) {
    if (cause.readings.size() != 1 || cause.indistinguishableFrom.empty()) continue;
    const ReadingDeviation& reading = cause.readings.front();
    const double sigma = statedSigma(*inquiry.base.measurement, reading.kind).arcseconds();
    return Advice{.measure = Measure::ZeroSightedAgain,
                  .separates = {cause.effect, cause.indistinguishableFrom.front()},
                  .bySigma = std::abs(reading.size) / (sigma * std::numbers::sqrt2)};
  }
  return std::nullopt;
}

/// What shows a jump that no reading shows, such as one between the zero and the first place.
std::optional<Advice> revealingJump(const Inquiry& inquiry, const std::vector<Detectability>& unseen) {
  const auto jump = std::ranges::find(unseen, jumpId, &Detectability::effect);
  if (jump == unseen.end()) return std::nullopt;
  const Measurement& measurement = *inquiry.base.measurement;
  const Eigen::Vector2d sigmas(statedSigma(measurement, ReadingKind::Horizontal).radians(),
                               statedSigma(measurement, ReadingKind::Vertical).radians());
  return Advice{.measure = Measure::ZeroSightedAgain,
                .separates = {jumpId},
                .bySigma = (plausibleJump * jump->weights).cwiseQuotient(sigmas).norm() / std::numbers::sqrt2,
                .ofUnseen = true};
}

/// The effects that the advice is about: the cause and its look-alikes, or else what could not be seen.
std::vector<const Effect*> effectsAt(const Cause* unclear, const std::vector<Detectability>& unseen) {
  std::vector<const Effect*> effects;
  const auto add = [&](std::string_view id) {
    if (const Effect* effect = effectById(id)) effects.push_back(effect);
  };
  if (unclear) {
    add(unclear->effect);
    for (const std::string& id : unclear->indistinguishableFrom) add(id);
  } else {
    for (const Detectability& detectability : unseen) add(detectability.effect);
  }
  return effects;
}

/// Of readings: the most telling first.
std::vector<Advice> furtherAdvice(const Inquiry& inquiry, const Cause* unclear,
                                  const std::vector<Detectability>& unseen) {
  const std::vector<const Effect*> effects = effectsAt(unclear, unseen);
  std::vector<Advice> list;
  if (effects.empty()) return list;
  FurtherTerms further(inquiry.base, inquiry.leftover.equations(), effects);
  eachFurtherReadings(inquiry.base, [&](const FurtherReadings& plan) {
    const VisibleTerms terms = further.shownBy(plan);
    const std::optional<Advice> advice =
        unclear ? separating(*unclear, plan.measure, terms) : revealing(unseen, plan.measure, terms);
    if (advice) list.push_back(*advice);
  });
  std::ranges::sort(list, [](const Advice& a, const Advice& b) {
    return std::pair(a.separates.size(), a.bySigma) > std::pair(b.separates.size(), b.bySigma);
  });
  return list;
}

}  // namespace

std::vector<Advice> adviceFor(const Inquiry& inquiry, const std::vector<Cause>& causes,
                              const std::vector<Detectability>& unseen) {
  const auto found = std::ranges::find_if(causes, [](const Cause& cause) {
    return effectById(cause.effect) && !cause.indistinguishableFrom.empty();
  });
  std::vector<Advice> list = furtherAdvice(inquiry, found == causes.end() ? nullptr : &*found, unseen);
  if (const std::optional<Advice> zero = tellingFromJump(inquiry, causes)) {
    list.insert(list.begin(), *zero);
  } else if (const std::optional<Advice> jump = revealingJump(inquiry, unseen)) {
    list.insert(found == causes.end() ? list.begin() : list.end(), *jump);
  }
  return list;
}

}  // namespace alidade
