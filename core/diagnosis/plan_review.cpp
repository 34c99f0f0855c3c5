#include "core/diagnosis/plan_review.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/observability/attainable.h"
#include "core/diagnosis/observability/further_terms.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/observability/undetectable.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// An effect, and two combinations of its parameters, of plausible size, in which it is examined.
struct Planned {
  const Effect* effect = nullptr;
  PlannedEffect summary;
  VectorXd plainest, mostDangerous;
};

/// Returns combinations of plausible size. For two parameters they cover a full turn, because a bent effect
/// differs between opposite signs.
std::vector<VectorXd> directionsOf(const Component& component) {
  constexpr int steps = 48;
  const VectorXd sizes = component.usualSizes();
  if (component.weights() == 1) return {sizes};
  std::vector<VectorXd> directions;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps;
    directions.emplace_back(Eigen::Vector2d(std::cos(angle), std::sin(angle)).cwiseProduct(sizes.head<2>()));
  }
  return directions;
}

void seeVisibility(Planned& planned, const Component& component, const Leftover& leftover,
                   const std::vector<EffectComponent>& components) {
  PlannedEffect& summary = planned.summary;
  bool first = true;
  for (const VectorXd& direction : directionsOf(component)) {
    const double visible = component.signatureLength(direction);
    if (first || visible < summary.leastVisible) summary.leastVisible = visible;
    if (first || visible > summary.mostVisible) {
      summary.mostVisible = visible;
      planned.plainest = direction;
    }
    first = false;
  }
  if (summary.mostVisible < thresholds.clearlyDifferent) return;
  const Trace trace(leftover, component.signature(leftover, planned.plainest));
  for (const EffectComponent& other : components) {
    if (other.id() == component.id() || other.isKnown()) continue;
    const LookAlike like = trace.compared(other);
    if (like.difference <= thresholds.clearlyDifferent) summary.lookAlikes.push_back(like);
  }
  std::ranges::sort(summary.lookAlikes, {}, &LookAlike::difference);
}

void seeInfluence(Planned& planned, const Component& component, const SharedProducts& perReading) {
  const Detectability detectability = detectabilityOf(component, perReading);
  PlannedEffect& summary = planned.summary;
  summary.influence = detectability.influence;
  planned.mostDangerous = detectability.influence > 0 ? detectability.weights : planned.plainest;
  summary.visibleThere = detectability.influence > 0 ? detectability.visible : summary.mostVisible;
  summary.undetectable = detectability.isUndetectable();
}

/// Returns the effects of the session's own model that have no known size.
std::vector<std::string> estimatedAlong(const Measurement& measurement) {
  std::vector<std::string> ids = measurement.effects;
  std::erase_if(ids, [&](const std::string& id) {
    const Effect* effect = effectById(id, measurement);
    return effect && knownOf(measurement, *effect);
  });
  return ids;
}

std::vector<Planned> plannedEffects(const GapModel& model, const Leftover& leftover) {
  const std::vector<EffectComponent> components =
      effectsBeyond(model, leftover, estimatedAlong(*model.measurement));
  const VectorXd perSigma = influencePerSigma(model);
  const SharedProducts perReading(leftover, perSigma);
  std::vector<Planned> effects;
  for (const EffectComponent& component : components) {
    Planned planned;
    planned.effect = &component.effect();
    planned.summary.effect = component.id();
    seeVisibility(planned, component, leftover, components);
    seeInfluence(planned, component, perReading);
    effects.push_back(std::move(planned));
  }
  return effects;
}

/// Returns the effects that further readings could clarify: undetectable effects and look-alikes.
std::vector<Planned> effectsInQuestion(const std::vector<Planned>& effects) {
  const auto isAlikeTo = [](const Planned& planned, const std::string& id) {
    return std::ranges::find(planned.summary.lookAlikes, id, &LookAlike::effect) !=
           planned.summary.lookAlikes.end();
  };
  std::vector<Planned> chosen;
  std::ranges::copy_if(effects, std::back_inserter(chosen), [&](const Planned& planned) {
    return planned.summary.undetectable || !planned.summary.lookAlikes.empty() ||
           std::ranges::any_of(
               effects, [&](const Planned& other) { return isAlikeTo(other, planned.summary.effect); });
  });
  return chosen;
}

/// Advice on `measures`. `inQuestion` are the effects to clarify, `shown` what the measures show of them.
PlanAdvice adviceOf(const std::vector<Measure>& measures, const VisibleTerms& shown,
                    const std::vector<Planned>& inQuestion) {
  PlanAdvice advice{measures, {}, {}};
  const auto plannedAs = [&](const std::string& id) -> const Planned& {
    return *std::ranges::find_if(inQuestion,
                                 [&](const Planned& planned) { return planned.summary.effect == id; });
  };
  const auto plainestOf = [](const Planned& planned) -> VectorXd {
    return combinationOf(*planned.effect) * planned.plainest;
  };
  for (const Planned& planned : inQuestion) {
    if (planned.summary.undetectable &&
        lengthOf(shown, combinationOf(*planned.effect) * planned.mostDangerous) > thresholds.clearlyDifferent)
      advice.reveals.push_back(planned.summary.effect);
    const VectorXd plainest = plainestOf(planned);
    for (const LookAlike& other : planned.summary.lookAlikes) {
      const std::pair pair(other.effect, planned.summary.effect);
      if (std::ranges::find(advice.separates, pair) == advice.separates.end() &&
          linearDifferenceFrom(shown, plainest, *plannedAs(other.effect).effect) >
              thresholds.clearlyDifferent &&
          linearDifferenceFrom(shown, plainestOf(plannedAs(other.effect)), *planned.effect) >
              thresholds.clearlyDifferent)
        advice.separates.emplace_back(planned.summary.effect, other.effect);
    }
  }
  std::ranges::sort(advice.reveals, std::greater{},
                    [&](const std::string& id) { return plannedAs(id).summary.influence; });
  return advice;
}

/// Sorts by the number of effects clarified, then by the number of measures. A combination remains only as
/// the first entry, where it clarifies more than every single measure.
void rank(std::vector<PlanAdvice>& list) {
  const auto clarified = [](const PlanAdvice& advice) {
    return std::pair(advice.reveals.size(), advice.separates.size());
  };
  std::ranges::stable_sort(list, {}, [](const PlanAdvice& advice) { return advice.measures.size(); });
  std::ranges::stable_sort(list, std::greater{}, clarified);
  bool isFirst = true;
  std::erase_if(list, [&](const PlanAdvice& advice) {
    const bool isUseless = advice.measures.size() > 1 && !isFirst;
    isFirst = false;
    return isUseless;
  });
}

/// Returns the model of the same readings without error.
Result<GapModel, NoModel> plannedModel(const Measurement& measurement, const SessionFit& fit) {
  const auto read = modelOf(measurement, fit);
  if (!read) return read.problem();
  return modelOf(readWithoutError(*read));
}

}  // namespace

Result<PlanReview, NoModel> reviewPlan(const Measurement& measurement) {
  return reviewPlan(measurement, fitSession(measurement));
}

Result<PlanReview, NoModel> reviewPlan(const Measurement& measurement, const SessionFit& fit) {
  auto own = plannedModel(measurement, fit);
  if (!own) return own.problem();
  PlanReview review{.effects = {}, .advice = {}, .intersection = estimateOf(*own)};
  const GapModel expected = withKnownSizes(*own);
  const GapModel model = closedModelOf(expected).value_or(expected);
  own = NoModel{};  // frees memory in proportion to the readings
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
  const std::vector<Planned> effects = plannedEffects(model, leftover);
  review.readings = static_cast<std::size_t>(
      std::ranges::count(leftover.equations().readings, false, &LinearReading::isZero));
  for (const Planned& planned : effects) review.effects.push_back(planned.summary);
  review.attainable = attainableUncertainties(model, 1);
  const std::vector<Planned> inQuestion = effectsInQuestion(effects);
  if (inQuestion.empty()) return review;
  std::vector<const Effect*> candidates;
  for (const Planned& planned : inQuestion) candidates.push_back(planned.effect);
  FurtherTerms further(model, leftover.equations(), candidates);
  const auto tryOut = [&](const FurtherReadings& plan) {
    PlanAdvice advice = adviceOf(plan.measures, further.shownBy(plan), inQuestion);
    if (!advice.reveals.empty() || !advice.separates.empty()) review.advice.push_back(std::move(advice));
  };
  eachFurtherReadings(model, tryOut);
  eachCombination(model, tryOut);
  rank(review.advice);
  return review;
}

}  // namespace alidade
