#include "core/diagnosis/sightings_ahead.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "core/base/statistics.h"
#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/next_sighting/all_possible.h"
#include "core/diagnosis/next_sighting/possible_sightings.h"
#include "core/diagnosis/next_sighting/sighting_equations.h"
#include "core/diagnosis/observability/attainable.h"

namespace alidade {

namespace {

/// Returns the measurement with the sighting `chosen` added; its reading follows from the arcs fitted so far.
Measurement after(const PossibleSighting& chosen, const Measurement& measurement,
                  const PossibleSightings& possible) {
  const ArcMeasurement& arc = possible.measurement.arcs[chosen.arc];
  Sighting taken = arc.sightings[chosen.sighting];
  taken.elapsed = 1;
  Measurement longer = measurement;
  countElapsedFrom(longer, longer.rows + 1);
  ++longer.rows;
  if (chosen.next.turnsAxis) {
    ArcMeasurement& turned = longer.arcs.emplace_back(arc);
    turned.sightings.clear();
    for (SightedZero& zero : turned.zeroSightings) zero.elapsed = 1;
    turned.zero.elapsed = 1;
  } else {  // `possible` refers directions to the first zero, `measurement` to that of the arc
    const ArcMeasurement& own = measurement.arcs[chosen.arc];
    taken.a = taken.a - wrapped(own.zeroHorizontal - arc.zeroHorizontal);
    taken.e = taken.e - (own.zeroElevation - arc.zeroElevation);
  }
  longer.arcs[chosen.arc].sightings.push_back(taken);
  return longer;
}

/// A session with the sightings chosen so far.
class Path {
 public:
  Path(double uncertainty, const Measurement& measurement, const SightingPlan& plan,
       const std::stop_token& stop)
      : m_uncertainty(uncertainty), m_plan(plan), m_stop(stop), m_measurement(measurement) {
    look();
  }

  const SightingsAhead& ahead() const { return m_ahead; }

  /// Adds the sighting that reduces U most for its minutes; false if there is none.
  bool goOn(bool turnsAxis) {
    const PossibleSighting* best = nullptr;
    for (const PossibleSighting& one : m_possible.possible)
      if (one.next.turnsAxis == turnsAxis && (!best || one.next.perMinute() > best->next.perMinute()))
        best = &one;
    if (!best) return false;
    m_ahead.minutes += best->next.minutes;
    m_ahead.sightings.push_back(best->next);
    m_measurement = after(*best, m_measurement, m_possible);
    m_plan.canTurnAxis = m_plan.canTurnAxis && !turnsAxis;
    look();
    return true;
  }

  void goOnTo(std::size_t count) {
    while (!m_ahead.isReached && m_ahead.sightings.size() < count && !m_stop.stop_requested() &&
           goOn(false)) {
    }
  }

  /// Turns the axis after as many sightings as in `other`, and adds as many sightings in total.
  void goOnLike(const SightingsAhead& other) {
    const auto turn = std::ranges::find_if(other.sightings, &NextSighting::turnsAxis);
    goOnTo(static_cast<std::size_t>(turn - other.sightings.begin()));
    if (turn != other.sightings.end()) goOn(true);
    goOnTo(other.sightings.size());
  }

  /// Returns U for each effect whose known size reduces U by a tenth or more.
  std::vector<AttainableUncertainty> withKnownEffects() const {
    std::vector<AttainableUncertainty> list;
    for (const Hypothesis& effect : m_equations.hypotheses) {
      if (!effect.widths) continue;
      const double share = m_every->sigmaKnowing(effect) / m_every->sigma();
      if (share <= worthwhileShare)
        list.push_back(
            {.measures = {}, .known = std::string(effect.cause), .expanded = share * *m_ahead.expanded});
    }
    return list;
  }

 private:
  double m_uncertainty;
  SightingPlan m_plan;
  std::stop_token m_stop;
  Measurement m_measurement;
  SightingsAhead m_ahead;
  PossibleSightings m_possible;   ///< with `ofUncertainty` filled in
  SightingEquations m_equations;  ///< with effects as the only hypotheses
  std::optional<IntersectionSoFar> m_every;

  void look() {
    m_equations = sightingEquations(m_measurement, m_plan, m_possible, true);
    m_every.emplace(m_equations);
    for (std::size_t i = 0; i < m_possible.possible.size(); ++i)
      m_possible.possible[i].next.ofUncertainty = m_every->logReductionBy(m_equations.possible[i]);
    if (!hasBothAxes(m_measurement)) return;
    m_ahead.expanded =
        coverageFactor(m_measurement.coverage, DegreesOfFreedom::infinite()) * m_every->sigma();
    m_ahead.isReached = *m_ahead.expanded <= m_uncertainty;
  }
};

/// First the plans that reach the uncertainty, by their minutes; then all other plans, by their U.
bool isBetter(const SightingsAhead& one, const SightingsAhead& other) {
  if (one.isReached != other.isReached) return one.isReached;
  if (one.isReached) return one.minutes < other.minutes;
  return one.expanded.value_or(INFINITY) < other.expanded.value_or(INFINITY);
}

SightingPlan withMeasure(SightingPlan plan, Measure measure) {
  if (measure == Measure::SliderReadings) plan.readsSlider = true;
  if (measure == Measure::BothFaces) plan.faces = {1, 2};
  return plan;
}

std::vector<AttainableUncertainty> insteadOf(const Path& best, const Measurement& measurement,
                                             const SightingPlan& plan, const std::stop_token& stop) {
  std::vector<AttainableUncertainty> instead{{{}, {}, *best.ahead().expanded}};
  for (const Measure measure : {Measure::SliderReadings, Measure::BothFaces}) {
    if (measure == Measure::SliderReadings ? plan.readsSlider : plan.faces.size() > 1) continue;
    Path path(0, measurement, withMeasure(plan, measure), stop);
    path.goOnLike(best.ahead());
    if (const auto expanded = path.ahead().expanded;
        expanded && *expanded <= worthwhileShare * *best.ahead().expanded)
      instead.push_back({{measure}, {}, *expanded});
  }
  std::ranges::move(best.withKnownEffects(), std::back_inserter(instead));
  std::ranges::stable_sort(instead.begin() + 1, instead.end(), {}, &AttainableUncertainty::expanded);
  return instead;
}

}  // namespace

SightingsAhead sightingsFor(double uncertainty, const Measurement& taken, const SightingPlan& plan,
                            std::size_t most, const std::stop_token& stop) {
  constexpr std::size_t numbersHere[] = {0, 5, 9, 14, 20, 28, 38, 50, 66};  // before the axis is turned
  const Measurement measurement = withNoise(taken, plan.noise);
  Path here(uncertainty, measurement, plan, stop);
  Path best = here;
  const auto keepBetter = [&](const Path& path) {
    if (isBetter(path.ahead(), best.ahead())) best = path;
  };
  for (const std::size_t number : numbersHere) {
    here.goOnTo(std::min(number, most));
    Path turned = here;
    if (plan.canTurnAxis && !turned.ahead().isReached && turned.ahead().sightings.size() < most &&
        turned.goOn(true))
      turned.goOnTo(most);
    keepBetter(turned);
    if (here.ahead().isReached || stop.stop_requested()) break;
  }
  here.goOnTo(most);
  keepBetter(here);
  SightingsAhead ahead = best.ahead();
  if (ahead.expanded && !ahead.isReached && !stop.stop_requested())
    ahead.instead = insteadOf(best, measurement, plan, stop);
  return ahead;
}

}  // namespace alidade
