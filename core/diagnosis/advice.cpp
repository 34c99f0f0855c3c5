#include "core/diagnosis/advice.h"

#include <algorithm>

#include "core/diagnosis/further_readings.h"
#include "core/diagnosis/known_components.h"
#include "core/diagnosis/look_alikes.h"

namespace alidade {

namespace {

using Eigen::VectorXd;

/// What the cause, at the size that was found, would leave in the planned readings.
VectorXd traceOf(const Leftover& leftover, const Cause& cause, const Component& component) {
  VectorXd weights(component.columns.cols());
  for (Eigen::Index p = 0; p < weights.size(); ++p)
    weights[p] = cause.parameters[static_cast<std::size_t>(p)].value /
                 component.effect->parameters[static_cast<std::size_t>(p)].plausible;
  return leftover.visible(component.columns * weights);
}

const Component* find(const std::vector<Component>& components, const std::string& id) {
  const auto found = std::ranges::find(components, id, &Component::id);
  return found == components.end() ? nullptr : &*found;
}

std::optional<Advice> separating(const Cause& cause, const FurtherReadings& plan, const Leftover& leftover,
                                 const std::vector<Component>& components) {
  const Component* own = find(components, cause.effect);
  if (!own) return std::nullopt;
  const VectorXd trace = traceOf(leftover, cause, *own);
  Advice advice{plan.measure, {cause.effect}, trace.norm()};
  for (const std::string& id : cause.indistinguishableFrom) {
    const Component* other = find(components, id);
    const double difference = other ? differenceFrom(trace, *other) : 0;
    if (difference < clearlyDifferent) continue;
    advice.separates.push_back(id);
    advice.bySigma = std::min(advice.bySigma, difference);
  }
  if (advice.separates.size() < 2) return std::nullopt;
  return advice;
}

std::optional<Advice> revealing(const std::vector<UnseenEffect>& unseen, const FurtherReadings& plan,
                                const std::vector<Component>& components) {
  constexpr double worthKnowing = 0.001;  // mm
  Advice advice{plan.measure, {}, 0};
  for (const UnseenEffect& effect : unseen) {
    const Component* component = find(components, effect.effect);
    if (!component || effect.influence < worthKnowing) continue;
    const double visible = component->columns.norm();
    if (visible < clearlyDifferent) continue;
    advice.bySigma = advice.separates.empty() ? visible : std::min(advice.bySigma, visible);
    advice.separates.push_back(effect.effect);
  }
  if (advice.separates.empty()) return std::nullopt;
  return advice;
}

}  // namespace

std::vector<Advice> adviceFor(const GapModel& model, const Diagnosis& diagnosis) {
  const auto unclear = std::ranges::find_if(
      diagnosis.causes, [](const Cause& cause) { return !cause.indistinguishableFrom.empty(); });
  if (unclear == diagnosis.causes.end() && diagnosis.unseen.empty()) return {};
  std::vector<Advice> list;
  for (const FurtherReadings& plan : furtherReadings(model)) {
    const Leftover leftover = leftoverWith(model, plan);
    const std::vector<Component> components = effectComponents(leftover, {}, {});
    const std::optional<Advice> advice = unclear != diagnosis.causes.end()
                                             ? separating(*unclear, plan, leftover, components)
                                             : revealing(diagnosis.unseen, plan, components);
    if (advice) list.push_back(*advice);
  }
  std::ranges::sort(list, [](const Advice& a, const Advice& b) {
    return std::pair(a.separates.size(), a.bySigma) > std::pair(b.separates.size(), b.bySigma);
  });
  return list;
}

}  // namespace alidade
