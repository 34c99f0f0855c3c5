#include "core/diagnosis/sightings_ahead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/statistics.h"
#include "core/diagnosis/next_sighting/sighting_equations.h"

namespace alidade {

namespace {

/// One row more: the elapsed shares count from a session longer by it.
void prolong(Measurement& measurement) {
  const auto gaps = [](std::size_t rows) { return std::max(1.0, static_cast<double>(rows) - 1); };
  const double share = gaps(measurement.rows) / gaps(measurement.rows + 1);
  ++measurement.rows;
  for (ArcMeasurement& arc : measurement.arcs) {
    arc.zero.elapsed *= share;
    for (SightedZero& zero : arc.zeroSightings) zero.elapsed *= share;
    for (Sighting& sighting : arc.sightings) sighting.elapsed *= share;
  }
}

/// The measurement after a further sighting, with the reading of the arcs fitted so far.
Measurement after(const NextSighting& next, const Measurement& measurement, const SightingPlan& plan) {
  PossibleSightings possible;
  sightingEquations(measurement, plan, possible);
  std::size_t index = possible.newArc;
  if (!next.turnsAxis)
    index = std::ranges::find_if(possible.possible, [](const PossibleSighting& sighting) {
              return !sighting.turnsAxis;
            })->arc;
  const ArcMeasurement& arc = possible.measurement.arcs[index];
  Sighting taken = *std::find_if(arc.sightings.begin() + static_cast<std::ptrdiff_t>(possible.taken[index]),
                                 arc.sightings.end(), [&](const Sighting& sighting) {
                                   return !sighting.isZero && sighting.point == next.point &&
                                          sighting.round == next.round && sighting.face == next.face;
                                 });
  taken.elapsed = 1;
  if (!next.turnsAxis) {  // there all directions refer to the first zero, here to that of their arc
    const ArcMeasurement& own = measurement.arcs[index];
    taken.a = taken.a - wrapped(own.zeroHorizontal - arc.zeroHorizontal);
    taken.e = taken.e - (own.zeroElevation - arc.zeroElevation);
  }
  Measurement longer = measurement;
  prolong(longer);
  if (next.turnsAxis) {
    longer.arcs.push_back(arc);
    longer.arcs.back().sightings.clear();
    for (SightedZero& zero : longer.arcs.back().zeroSightings) zero.elapsed = 1;
    longer.arcs.back().zero.elapsed = 1;
  }
  longer.arcs[index].sightings.push_back(taken);
  return longer;
}

/// A session with the sightings chosen so far.
class Path {
 public:
  Path(double uncertainty, const Measurement& measurement, const SightingPlan& plan)
      : m_uncertainty(uncertainty), m_plan(plan), m_measurement(measurement) {
    look();
  }

  const SightingsAhead& ahead() const { return m_ahead; }

  /// Takes the sighting that takes most off U for its minutes; false if there is none.
  bool goOn(bool turnsAxis) {
    const auto next = std::ranges::find(m_ranked, turnsAxis, &NextSighting::turnsAxis);
    if (next == m_ranked.end()) return false;
    m_ahead.minutes += next->minutes;
    m_ahead.sightings.push_back(*next);
    m_measurement = after(*next, m_measurement, m_plan);
    m_plan.canTurnAxis = m_plan.canTurnAxis && !turnsAxis;
    look();
    return true;
  }

  void goOnToTheEnd(std::size_t most) {
    while (!m_ahead.isReached && m_ahead.sightings.size() < most && goOn(false)) {
    }
  }

 private:
  double m_uncertainty;
  SightingPlan m_plan;
  Measurement m_measurement;
  SightingsAhead m_ahead;
  std::vector<NextSighting> m_ranked;

  void look() {
    m_ranked.clear();
    auto state = sessionSoFar(m_measurement, m_plan, {.uncertainty = m_uncertainty});
    if (!state) return;
    if (state->sigma)
      m_ahead.expanded = coverageFactor(m_measurement.coverage, DegreesOfFreedom::infinite()) * *state->sigma;
    m_ahead.isReached = m_ahead.expanded && *m_ahead.expanded <= m_uncertainty;
    m_ranked = std::move(state->ranked);
  }
};

/// What is reached comes before what is not, then the fewer minutes, or else the smaller U.
bool isBetter(const SightingsAhead& one, const SightingsAhead& other) {
  if (one.isReached != other.isReached) return one.isReached;
  if (one.isReached) return one.minutes < other.minutes;
  return one.expanded.value_or(INFINITY) < other.expanded.value_or(INFINITY);
}

}  // namespace

SightingsAhead sightingsFor(double uncertainty, const Measurement& measurement, const SightingPlan& plan,
                            std::size_t most) {
  constexpr std::size_t numbersHere[] = {0, 5, 9, 14, 20, 28, 38, 50, 66};  // before the axis is turned
  Path here(uncertainty, measurement, plan);
  SightingsAhead best = here.ahead();
  for (const std::size_t number : numbersHere) {
    while (!here.ahead().isReached && here.ahead().sightings.size() < std::min(number, most) &&
           here.goOn(false)) {
    }
    Path turned = here;
    if (plan.canTurnAxis && !turned.ahead().isReached && turned.ahead().sightings.size() < most &&
        turned.goOn(true))
      turned.goOnToTheEnd(most);
    if (isBetter(turned.ahead(), best)) best = turned.ahead();
    if (here.ahead().isReached) break;
  }
  here.goOnToTheEnd(most);
  return isBetter(here.ahead(), best) ? here.ahead() : best;
}

}  // namespace alidade
