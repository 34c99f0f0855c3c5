#include "core/diagnosis/advice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/diagnosis/known_components.h"
#include "core/diagnosis/look_alikes.h"
#include "core/observation/observe.h"

namespace alidade {

namespace {

using Eigen::VectorXd;

/// A way to read more, and what would then have been read: one set-up or several.
struct Plan {
  std::string measure;
  std::vector<Measurement> sets;
};

double arcAngle(const GapModel& model, std::size_t arc, std::size_t sighting) {
  return model.fit.arcAngles[arc][sighting];
}

void sightPerfectly(Sighting& sighting, const Measurement& measurement, const Circle& circle, double phi) {
  const Direction<double> seen = observe(targetOnArc(circle.x, circle.y, circle.radius, phi),
                                         measurement.distance, measurement.relation);
  sighting.a = Angle::fromRadians(seen.a);
  sighting.e = Angle::fromRadians(seen.e);
}

/// The session as it was planned: every reading without error.
Measurement planned(const GapModel& model) {
  Measurement plan = model.measurement;
  for (std::size_t arc = 0; arc < plan.arcs.size(); ++arc)
    for (std::size_t i = 0; i < plan.arcs[arc].sightings.size(); ++i) {
      Sighting& sighting = plan.arcs[arc].sightings[i];
      const double phi = arcAngle(model, arc, i);
      sightPerfectly(sighting, plan, model.fit.circleOf(arc), phi);
      if (sighting.slider) sighting.slider = Angle::fromRadians(plan.arcs[arc].axisDeg == 0 ? phi : -phi);
    }
  return plan;
}

/// Rows numbered anew in the order they stand in.
void renumber(Measurement& plan) {
  plan.rows = 0;
  for (ArcMeasurement& arc : plan.arcs)
    for (Sighting& sighting : arc.sightings) sighting.sequence = plan.rows++;
}

std::optional<Plan> withBothFaces(const Measurement& plan) {
  Measurement more = plan;
  bool added = false;
  for (ArcMeasurement& arc : more.arcs) {
    std::vector<Sighting> rows;
    for (const Sighting& sighting : arc.sightings) {
      rows.push_back(sighting);
      const auto twin = std::ranges::find_if(arc.sightings, [&](const Sighting& other) {
        return other.point == sighting.point && other.round == sighting.round && other.face != sighting.face;
      });
      if (twin != arc.sightings.end()) continue;
      rows.push_back(sighting);
      rows.back().face = 3 - sighting.face;
      added = true;
    }
    arc.sightings = std::move(rows);
  }
  if (!added) return std::nullopt;
  renumber(more);
  return Plan{"both faces", {more}};
}

std::optional<Plan> withWayBack(const Measurement& plan) {
  Measurement more = plan;
  for (ArcMeasurement& arc : more.arcs) {
    int rounds = 1;
    for (const Sighting& sighting : arc.sightings) rounds = std::max(rounds, sighting.round);
    if (rounds > 1) return std::nullopt;
    std::vector<Sighting> back(arc.sightings.rbegin(), arc.sightings.rend());
    for (Sighting& sighting : back) sighting.round = rounds + 1;
    arc.sightings.insert(arc.sightings.end(), back.begin(), back.end());
  }
  renumber(more);
  return Plan{"the way back", {more}};
}

std::optional<Plan> withSlider(const GapModel& model, const Measurement& plan) {
  Measurement more = plan;
  bool added = false;
  for (std::size_t arc = 0; arc < more.arcs.size(); ++arc)
    for (std::size_t i = 0; i < more.arcs[arc].sightings.size(); ++i) {
      Sighting& sighting = more.arcs[arc].sightings[i];
      if (sighting.slider) continue;
      const double phi = arcAngle(model, arc, i);
      sighting.slider = Angle::fromRadians(more.arcs[arc].axisDeg == 0 ? phi : -phi);
      added = true;
    }
  if (!added) return std::nullopt;
  return Plan{"slider readings", {more}};
}

std::optional<Plan> withShiftedCircle(const Measurement& plan) {
  Measurement more = plan;
  for (ArcMeasurement& arc : more.arcs) arc.zeroHorizontal = arc.zeroHorizontal + Angle::fromDegrees(60);
  return Plan{"a second set with the horizontal circle shifted by 60°", {plan, more}};
}

std::optional<Plan> withSecondStandOff(const GapModel& model, const Measurement& plan) {
  constexpr double farther = 1.5;
  Measurement more = plan;
  more.distance *= farther;
  for (std::size_t arc = 0; arc < more.arcs.size(); ++arc)
    for (std::size_t i = 0; i < more.arcs[arc].sightings.size(); ++i)
      sightPerfectly(more.arcs[arc].sightings[i], more, model.fit.circleOf(arc), arcAngle(model, arc, i));
  return Plan{"a second set from half as far again", {plan, more}};
}

std::optional<Plan> withMoreArc(const GapModel& model, const Measurement& plan) {
  constexpr double enough = 150, whole = 160;  // degrees
  constexpr int points = 17;
  Measurement more = plan;
  bool added = false;
  for (std::size_t arc = 0; arc < more.arcs.size(); ++arc) {
    const int side = more.arcs[arc].axisDeg == 0 ? 1 : -1;
    const auto& angles = model.fit.arcAngles[arc];
    const auto [least, most] = std::ranges::minmax(angles);
    if ((most - least) * 180 / std::numbers::pi > enough) continue;
    int point = 0;
    for (const Sighting& sighting : more.arcs[arc].sightings) point = std::max(point, sighting.point);
    for (int k = 0; k < points; ++k) {
      const double phi = side * (90 - whole / 2 + whole * k / (points - 1)) * std::numbers::pi / 180;
      if (phi >= least && phi <= most) continue;
      Sighting sighting;
      sighting.point = ++point;
      sightPerfectly(sighting, more, model.fit.circleOf(arc), phi);
      more.arcs[arc].sightings.push_back(sighting);
      added = true;
    }
  }
  if (!added) return std::nullopt;
  renumber(more);
  return Plan{"more of the arc", {more}};
}

std::vector<Plan> plansFor(const GapModel& model) {
  const Measurement plan = planned(model);
  std::vector<Plan> plans;
  for (std::optional<Plan> more :
       {withBothFaces(plan), withWayBack(plan), withSlider(model, plan), withShiftedCircle(plan),
        withSecondStandOff(model, plan), withMoreArc(model, plan)})
    if (more) plans.push_back(*std::move(more));
  return plans;
}

Leftover leftoverOf(const GapModel& model, const Plan& plan) {
  std::vector<Circle> starts;
  for (std::size_t arc = 0; arc < model.measurement.arcs.size(); ++arc)
    starts.push_back(model.fit.circleOf(arc));
  JointFitOptions options;
  options.terms = model.options.terms;
  for (EstimatedTerm& term : options.terms) term.start = 0;
  std::vector<Linearised> sets;
  for (const Measurement& set : plan.sets)
    sets.push_back(linearise(set, fitJointly(set, starts, options), options));
  return Leftover(sets, options.terms);
}

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

std::optional<Advice> separating(const Cause& cause, const Plan& plan, const Leftover& leftover,
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

std::optional<Advice> revealing(const std::vector<UnseenEffect>& unseen, const Plan& plan,
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
  for (const Plan& plan : plansFor(model)) {
    const Leftover leftover = leftoverOf(model, plan);
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
