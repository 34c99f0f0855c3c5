#include "core/diagnosis/next_sighting.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/statistics.h"
#include "core/diagnosis/next_sighting/all_possible.h"
#include "core/diagnosis/next_sighting/weighed.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// Returns the hypotheses whose probability matters.
std::vector<Weighed> likely(const std::vector<Weighed>& all) {
  constexpr std::size_t most = 14;
  constexpr double least = 5e-4;
  std::vector<Weighed> list;
  for (const Weighed& weighed : all)
    if (list.size() < most && weighed.probability >= least) list.push_back(weighed);
  return list;
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

std::vector<NextSighting> ranked(const PossibleSightings& session, const SightingEquations& equations,
                                 const WeighedCauses& causes, const IntersectionSoFar& every) {
  const std::vector<Weighed> some = likely(causes.all());
  std::vector<NextSighting> list;
  for (std::size_t i = 0; i < session.possible.size(); ++i) {
    NextSighting next = session.possible[i].next;
    const SightingRows& rows = equations.possible[i];
    addCauses(next, some, WeighedCauses::Predictor(causes, rows));
    next.ofUncertainty = every.tells(rows);
    list.push_back(std::move(next));
  }
  std::ranges::stable_sort(list, std::greater{}, &NextSighting::perMinute);
  return list;
}

/// Half the width of the range that contains Δd at all times together with probability 1 − α: a normal
/// mixture of prior width 1 mm.
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

/// Fills in the group of the most probable cause if the evidence against no cause suffices, the group holds
/// almost all of the probability, and the residuals with the cause are no more than noise. The redundancy
/// must suffice for this test. Larger noise is never named: an uncatalogued effect may look the same.
void name(SessionSoFar& state, const WeighedCauses& causes, const SightingEquations& equations) {
  constexpr double certain = 0.95, noMore = 1e-3, leastRedundancy = 12;
  const Weighed& first = causes.all().front();
  if (first.cause.empty() || first.cause == noiseId || !isEvident(state)) return;
  std::vector<std::string> group = inseparableFrom(first, equations);
  double probability = 0;
  for (const WeighedCause& cause : state.causes)
    if (std::ranges::find(group, cause.cause) != group.end()) probability += cause.probability;
  const double left = causes.degreesOfFreedom() - static_cast<double>(first.weights.size());
  if (left < leastRedundancy) return;
  const auto tail = chiSquareUpperTail(causes.chiSquareAfter(first), DegreesOfFreedom(left));
  if (probability >= certain && tail.value_or(1) > noMore) state.named = std::move(group);
}

bool isAnyWorthIt(const std::vector<NextSighting>& ranked) {
  constexpr double leastWorth = 0.001;
  return std::ranges::any_of(ranked, [&](const NextSighting& next) { return next.worth() > leastWorth; });
}

Enough enoughOf(const SessionSoFar& state, const Measurement& measurement, bool ranks) {
  if (!state.named.empty()) return Enough::Named;
  if (isVerdictCertain(measurement, state)) return Enough::VerdictCertain;
  return !ranks || isAnyWorthIt(state.ranked) ? Enough::No : Enough::WillNotHelp;
}

}  // namespace

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
  for (const Weighed& cause : causes.all())
    state.causes.push_back({std::string(cause.cause), cause.probability});
  if (hasBothAxes(measurement)) {
    state.intersection = every.value();
    state.sigma = every.sigma();
    state.halfWidth = halfWidthAtAllTimes(every.sigma(), 1 - measurement.coverage);
  }
  if (!std::isfinite(state.logEvidence)) return std::nullopt;
  name(state, causes, equations);
  if (ranks) state.ranked = ranked(session, equations, causes, every);
  state.enough = enoughOf(state, measurement, ranks);
  state.isWithin =
      measurement.tolerance && state.intersection && std::abs(*state.intersection) <= *measurement.tolerance;
  return state;
}

}  // namespace alidade
