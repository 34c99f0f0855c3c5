#include "core/diagnosis/next_sighting/possible_sightings.h"

#include <algorithm>
#include <utility>

#include "core/adjustment/joint/sighted_zeros.h"
#include "core/observation/half_turn.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

/// The latest sighting; `arc` becomes the index of its arc.
const Sighting& latestOf(const Measurement& measurement, std::size_t& arc) {
  const Sighting* latest = nullptr;
  for (std::size_t i = 0; i < measurement.arcs.size(); ++i)
    for (const Sighting& sighting : measurement.arcs[i].sightings)
      if (!latest || sighting.order > latest->order) {
        latest = &sighting;
        arc = i;
      }
  return *latest;
}

/// The number of intervals between this many rows, at least 1.
double intervalsOf(std::size_t rows) {
  return std::max(1.0, static_cast<double>(rows) - 1);
}

/// A sighting at the moment of the row after `last`.
Sighting following(const Sighting& last, std::size_t rows) {
  Sighting next;
  next.order = last.order + 1;
  next.sequence = last.sequence + 1;
  next.elapsed = last.elapsed + 1 / intervalsOf(rows);
  return next;
}

/// The round in which `point` would be sighted. It is that of the last visit if the slider is still there and
/// `face` was not sighted, else a new one.
int roundOf(const ArcMeasurement& arc, const Sighting& last, int point, int face) {
  int round = 0;
  bool hasFace = false;
  for (const Sighting& sighting : arc.sightings) {
    if (sighting.point == point) round = std::max(round, sighting.round);
    hasFace =
        hasFace || (sighting.point == last.point && sighting.round == last.round && sighting.face == face);
  }
  return last.point == point && !hasFace ? last.round : round + 1;
}

/// The arc that a turn of the axis would begin, with its zero at the moment of the next row.
ArcMeasurement arcAfterTurn(const Measurement& measurement, const ArcMeasurement& current,
                            const Sighting& next) {
  ArcMeasurement turned = current;
  turned.axisDeg = 180 - current.axisDeg;
  turned.position = measurement.arcs.back().position + 1;
  turned.sightings.clear();
  turned.zero = {.elapsed = next.elapsed};
  turned.zeroSightings = {{.a = {}, .e = {}, .order = next.order, .elapsed = next.elapsed}};
  turned.repeat =
      1 + static_cast<int>(std::ranges::count(measurement.arcs, turned.axisDeg, &ArcMeasurement::axisDeg));
  return turned;
}

/// `next` with its minutes after `last`; the axis angle is still to be set.
NextSighting costed(const Sighting& next, const Sighting& last, bool turns, const SightingMinutes& minutes) {
  const SightingMoves moves{.turnsAxis = turns,
                            .sightsZero = turns,
                            .plungesTelescope = next.face != last.face,
                            .drivesSlider = turns || next.point != last.point};
  return {.point = next.point,
          .face = next.face,
          .round = next.round,
          .turnsAxis = turns,
          .minutes = minutesOf(minutes, moves)};
}

/// The last sighting taken at `point`; null if there is none. The slider may have deviated from the plan.
const Sighting* takenAt(const ArcMeasurement& arc, std::size_t taken, int point) {
  for (std::size_t k = taken; k-- > 0;)
    if (!arc.sightings[k].isZero && arc.sightings[k].point == point) return &arc.sightings[k];
  return nullptr;
}

}  // namespace

void countElapsedFrom(Measurement& measurement, std::size_t rows) {
  const double share = intervalsOf(measurement.rows) / intervalsOf(rows);
  for (ArcMeasurement& arc : measurement.arcs) {
    arc.zero.elapsed *= share;
    for (SightedZero& zero : arc.zeroSightings) zero.elapsed *= share;
    for (Sighting& sighting : arc.sightings) sighting.elapsed *= share;
  }
}

PossibleSightings possibleSightings(const Measurement& taken, const SightingPlan& plan) {
  PossibleSightings session;
  session.newArc = taken.arcs.size();
  Measurement all = taken;
  countElapsedFrom(all, plan.rows);
  std::size_t current = 0;
  const Sighting last = latestOf(all, current);
  Sighting next = following(last, plan.rows);
  all.arcs.push_back(arcAfterTurn(taken, taken.arcs[current], next));
  for (const ArcMeasurement& arc : all.arcs) session.taken.push_back(arc.sightings.size());
  const auto add = [&](std::size_t index, const SightingPlace& place, int face) {
    ArcMeasurement& arc = all.arcs[index];
    const bool turns = index == session.newArc;
    next.point = place.point;
    next.face = face;
    next.round = turns ? 1 : roundOf(taken.arcs[current], last, place.point, face);
    if (plan.readsSlider) next.slider = place.s;
    session.possible.push_back({index, arc.sightings.size(), costed(next, last, turns, plan.minutes)});
    session.possible.back().next.axisDeg = arc.axisDeg;
    arc.sightings.push_back(next);
  };
  for (const std::size_t arc : {current, session.newArc})
    if (arc == current || plan.canTurnAxis)
      for (const SightingPlace& place : plan.places)
        for (const int face : plan.faces) add(arc, place, face);
  session.measurement = withZerosSighted(std::move(all));
  return session;
}

void sightPossible(PossibleSightings& session, const SightingPlan& plan, const std::vector<Circle>& circles) {
  for (const PossibleSighting& possible : session.possible) {
    ArcMeasurement& arc = session.measurement.arcs[possible.arc];
    Sighting& sighting = arc.sightings[possible.sighting];
    if (const Sighting* there = takenAt(arc, session.taken[possible.arc], sighting.point)) {
      sighting.a = there->a;
      sighting.e = there->e;
      if (sighting.slider && there->slider) sighting.slider = there->slider;
      continue;
    }
    const auto place = std::ranges::find(plan.places, sighting.point, &SightingPlace::point);
    sightPerfectly(sighting, ZeroLine(session.measurement, arc), circles[possible.arc],
                   arcAngleOf(place->s.radians(), arc.axisDeg));
    if (sighting.slider) sighting.slider = place->s;
  }
}

}  // namespace alidade
