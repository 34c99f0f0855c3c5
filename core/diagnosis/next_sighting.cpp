#include "core/diagnosis/next_sighting.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/statistics.h"
#include "core/diagnosis/evidence/gain.h"
#include "core/diagnosis/next_sighting/all_possible.h"
#include "core/diagnosis/next_sighting/weighed.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// Returns the most probable hypotheses; the others are negligible.
std::vector<Weighed> likely(std::vector<Weighed> all) {
  constexpr std::size_t most = 14;
  constexpr double least = 5e-4;
  all.resize(std::min(all.size(), most));
  std::erase_if(all, [](const Weighed& weighed) { return weighed.probability < least; });
  return all;
}

/// Adds the value of a sighting for separating the causes.
void addCauses(NextSighting& next, const std::vector<Weighed>& causes,
               const WeighedCauses::Predictor& predictor) {
  std::vector<Prediction> predictions;
  for (const Weighed& cause : causes) predictions.push_back(predictor.under(cause));
  double most = 0;
  for (std::size_t i = 0; i < causes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double worth = std::sqrt(causes[i].probability * causes[j].probability) *
                           (1 - overlapOf(predictions[i], predictions[j]));
      next.ofCauses += worth;
      if (worth <= most) continue;
      most = worth;
      next.one = causes[j].cause;
      next.other = causes[i].cause;
    }
}

/// `equations` are those without a certain cause in the model.
std::vector<NextSighting> ranked(const PossibleSightings& session, const SightingEquations& equations,
                                 const WeighedCauses& causes, const IntersectionSoFar& every) {
  const std::vector<Weighed> some = likely(causes.all());
  std::vector<NextSighting> list;
  for (std::size_t i = 0; i < session.possible.size(); ++i) {
    NextSighting next = session.possible[i].next;
    addCauses(next, some, WeighedCauses::Predictor(causes, causes.equations().possible[i]));
    next.ofUncertainty = every.logReductionBy(equations.possible[i]);
    list.push_back(std::move(next));
  }
  std::ranges::stable_sort(list, std::greater{}, &NextSighting::perMinute);
  return list;
}

/// Half the width of the range that contains Δd at all times together with probability 1 − α. It follows from
/// a normal mixture of prior width 1 mm.
double halfWidthAtAllTimes(double sigma, double alpha) {
  constexpr double prior = 1;  // mm
  const double ratio = sigma * sigma / (prior * prior);
  return sigma * std::sqrt((1 + ratio) * (std::log1p(1 / ratio) - 2 * std::log(alpha)));
}

bool isEvident(const SessionSoFar& state) {
  return state.logEvidence >= state.logEvidenceNeeded;
}

/// False while there is evidence of an unnamed cause: that cause may be noise larger than stated.
bool isVerdictCertain(const Measurement& measurement, const SessionSoFar& state) {
  if (!measurement.tolerance || !state.intersection || isEvident(state)) return false;
  const double size = std::abs(*state.intersection);
  return size + state.halfWidth < *measurement.tolerance || size - state.halfWidth > *measurement.tolerance;
}

std::vector<WeighedCause> listOf(const WeighedCauses& causes) {
  std::vector<WeighedCause> list;
  for (const Weighed& cause : causes.all()) list.push_back({std::string(cause.cause), cause.probability});
  return list;
}

/// Whether the hypothesis is an effect, a jump or a gross error. A form is weighed alone: a second cause
/// would only take up what the grid of forms misses.
bool mayBeOfTwo(const Weighed& weighed) {
  return !weighed.cause.empty() && weighed.cause != noiseId && weighed.cause != formId;
}

/// The probabilities if each cause is present alone, or `first` together with any of `further`.
std::vector<WeighedCause> listOf(const WeighedCauses& causes, const Weighed& first,
                                 const WeighedCauses& further) {
  double together = impossible, whole = impossible;
  for (const Weighed& cause : further.all()) together = logSum(together, cause.logOdds);
  const auto logOddsOf = [&](const Weighed& cause) {
    return cause.logOdds + (cause.cause == first.cause ? together : 0);
  };
  for (const Weighed& cause : causes.all()) whole = logSum(whole, logOddsOf(cause));
  std::vector<WeighedCause> list;
  for (const Weighed& cause : causes.all())
    list.push_back({std::string(cause.cause), std::exp(logOddsOf(cause) - whole)});
  std::ranges::stable_sort(list, std::greater{}, &WeighedCause::probability);
  return list;
}

bool isCertain(const std::vector<std::string>& group, const std::vector<WeighedCause>& causes) {
  return probabilityOf(group, causes) >= thresholds.certain;
}

/// Whether the residuals with the cause are no more than noise. The redundancy must suffice for this test.
bool leavesOnlyNoise(const WeighedCauses& causes, const Weighed& cause) {
  constexpr double leastRedundancy = 12;
  const double left = causes.degreesOfFreedom() - static_cast<double>(cause.weights.size());
  if (left < leastRedundancy) return false;
  return chiSquareUpperTail(causes.chiSquareAfter(cause), DegreesOfFreedom(left)).value_or(1) > improbable;
}

/// The group of a second cause that is certain given the first. The first must also be certain given the
/// second, otherwise the second may only mimic two other causes. Empty without such a cause.
std::vector<std::string> secondGroup(const SessionSoFar& state, const WeighedCauses& causes,
                                     const WeighedCauses& further) {
  const Weighed& second = further.all().front();
  if (!mayBeOfTwo(second) || further.logEvidence() < state.logEvidenceNeeded ||
      !leavesOnlyNoise(further, second))
    return {};
  std::vector<std::string> group = inseparableFrom(second, further.equations());
  if (!isCertain(group, state.further)) return {};
  if (group == state.certain) return group;
  const Weighed& alone = *std::ranges::find(causes.all(), second.cause, &Weighed::cause);
  const SightingEquations given = withCause(causes.equations(), alone, group);
  if (!isCertain(state.certain, listOf(WeighedCauses(given)))) group.clear();
  return group;
}

/// Weighs further causes in addition to the likeliest one. If the likeliest is certain, names it or both
/// causes and returns true. Larger noise is never named: an uncatalogued effect may look the same.
bool weighFurther(SessionSoFar& state, const WeighedCauses& causes, const auto& rank) {
  // With a smaller limit, a session with one cause would need many more sightings.
  constexpr double leastLeft = 0.6;
  const auto first = std::ranges::find_if(causes.all(), mayBeOfTwo);
  if (first == causes.all().end() || !isEvident(state)) return false;
  std::vector<std::string> group = inseparableFrom(*first, causes.equations());
  const SightingEquations extended = withCause(causes.equations(), *first, group);
  const WeighedCauses further(extended);
  state.causes = listOf(causes, *first, further);
  if (!isCertain(group, state.causes)) return false;
  state.certain = std::move(group);
  state.further = listOf(further);
  state.isAlone = further.logEvidence() <= std::log(leastLeft);
  state.alsoNamed = secondGroup(state, causes, further);
  if (!state.alsoNamed.empty() || leavesOnlyNoise(causes, *first)) state.named = state.certain;
  rank(further);
  return true;
}

/// Whether a form is certain, with the likeliest pair of other causes as an alternative.
bool isFormCertain(const SessionSoFar& state, const WeighedCauses& causes) {
  const auto form = std::ranges::find(causes.all(), formId, &Weighed::cause);
  return form != causes.all().end() && isEvident(state) && isCertain({formId}, state.causes) &&
         leavesOnlyNoise(causes, *form);
}

Enough enoughOf(const SessionSoFar& state, const Measurement& measurement, bool ranks) {
  constexpr double leastWorth = 0.001;
  const auto isWorthIt = [](const NextSighting& next) { return next.worth() > leastWorth; };
  const bool isAnyWorth = !ranks || std::ranges::any_of(state.ranked, isWorthIt);
  const bool isComplete = state.isAlone || !state.alsoNamed.empty() || !isAnyWorth;
  if (!state.named.empty() && isComplete) return Enough::Named;
  if (isVerdictCertain(measurement, state)) return Enough::VerdictCertain;
  return isAnyWorth ? Enough::No : Enough::WillNotHelp;
}

}  // namespace

double probabilityOf(const std::vector<std::string>& group, const std::vector<WeighedCause>& causes) {
  double sum = 0;
  for (const WeighedCause& cause : causes)
    if (std::ranges::find(group, cause.cause) != group.end()) sum += cause.probability;
  return sum;
}

std::optional<SessionSoFar> sessionSoFar(const Measurement& measurement, const SightingPlan& plan,
                                         bool ranks) {
  if (measurement.arcs.empty() || plan.places.empty()) return std::nullopt;
  PossibleSightings session;
  const SightingEquations equations = sightingEquations(measurement, plan, session);
  const WeighedCauses causes(equations);
  const IntersectionSoFar every(equations);
  SessionSoFar state;
  state.logEvidence = causes.logEvidence();
  constexpr double alpha = 0.01;
  state.logEvidenceNeeded = -std::log(alpha);
  state.causes = listOf(causes);
  if (hasBothAxes(measurement)) {
    state.intersection = every.value();
    state.sigma = every.sigma();
    state.halfWidth = halfWidthAtAllTimes(every.sigma(), 1 - measurement.coverage);
  }
  if (!std::isfinite(state.logEvidence)) return std::nullopt;
  const auto rank = [&](const WeighedCauses& weighed) {
    if (ranks) state.ranked = ranked(session, equations, weighed, every);
  };
  if (!weighFurther(state, causes, rank)) {
    if (isFormCertain(state, causes)) state.named = {formId};
    rank(causes);
  }
  state.enough = enoughOf(state, measurement, ranks);
  state.isWithin =
      measurement.tolerance && state.intersection && std::abs(*state.intersection) <= *measurement.tolerance;
  return state;
}

}  // namespace alidade
