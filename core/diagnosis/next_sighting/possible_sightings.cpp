#include "core/diagnosis/next_sighting/possible_sightings.h"

#include <algorithm>
#include <utility>

#include "core/adjustment/joint/sighted_zeros.h"
#include "core/observation/half_turn.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

const Sighting* lastOf(const Measurement& measurement, std::size_t& arc) {
  const Sighting* last = nullptr;
  for (std::size_t i = 0; i < measurement.arcs.size(); ++i)
    for (const Sighting& sighting : measurement.arcs[i].sightings)
      if (!last || sighting.order > last->order) {
        last = &sighting;
        arc = i;
      }
  return last;
}

/// The round in which `point` would be sighted. It is that of the last visit if the slider is still there and
/// `face` was not sighted, else a new one.
int roundOf(const ArcMeasurement& arc, const Sighting* last, int point, int face) {
  int round = 0;
  bool hasFace = false;
  for (const Sighting& sighting : arc.sightings) {
    if (sighting.point == point) round = std::max(round, sighting.round);
    hasFace = hasFace || (last && sighting.point == last->point && sighting.round == last->round &&
                          sighting.face == face);
  }
  return last && last->point == point && !hasFace ? last->round : round + 1;
}

/// The arc that a turn of the axis would begin, with its zero at the moment of the next row.
ArcMeasurement arcAfterTurn(const Measurement& measurement, const ArcMeasurement& current,
                            const SightedZero& zero) {
  ArcMeasurement next = current;
  next.axisDeg = 180 - current.axisDeg;
  next.position = measurement.arcs.back().position + 1;
  next.sightings.clear();
  next.zero = {};
  next.zero.elapsed = zero.elapsed;
  next.zeroSightings = {zero};
  next.repeat =
      1 + static_cast<int>(std::ranges::count(measurement.arcs, next.axisDeg, &ArcMeasurement::axisDeg));
  return next;
}

/// The last sighting taken at `point`; null if there is none. The slider may have deviated from the plan.
const Sighting* takenAt(const ArcMeasurement& arc, std::size_t taken, int point) {
  for (std::size_t k = taken; k-- > 0;)
    if (!arc.sightings[k].isZero && arc.sightings[k].point == point) return &arc.sightings[k];
  return nullptr;
}

SightedZero sightedZeroOf(const Sighting& next) {
  SightedZero zero;
  zero.order = next.order;
  zero.elapsed = next.elapsed;
  return zero;
}

}  // namespace

void countElapsedFrom(Measurement& measurement, std::size_t rows) {
  const auto gaps = [](std::size_t count) { return std::max(1.0, static_cast<double>(count) - 1); };
  const double share = gaps(measurement.rows) / gaps(rows);
  for (ArcMeasurement& arc : measurement.arcs) {
    arc.zero.elapsed *= share;
    for (SightedZero& zero : arc.zeroSightings) zero.elapsed *= share;
    for (Sighting& sighting : arc.sightings) sighting.elapsed *= share;
  }
}

PossibleSightings possibleSightings(const Measurement& taken, const SightingPlan& plan) {
  PossibleSightings session{.measurement = taken, .taken = {}, .possible = {}};
  Measurement& all = session.measurement;
  for (const ArcMeasurement& arc : all.arcs) session.taken.push_back(arc.sightings.size());
  std::size_t current = 0;
  countElapsedFrom(all, plan.rows);
  const Sighting* found = lastOf(all, current);
  const Sighting last = found ? *found : Sighting{};
  Sighting next;
  next.order = last.order + 1;
  next.sequence = last.sequence + 1;
  next.elapsed = last.elapsed + 1 / std::max(1.0, static_cast<double>(plan.rows) - 1);
  all.arcs.push_back(arcAfterTurn(taken, taken.arcs[current], sightedZeroOf(next)));
  session.taken.push_back(0);
  session.newArc = all.arcs.size() - 1;
  for (const std::size_t arc : {current, session.newArc}) {
    const ArcMeasurement before = all.arcs[arc];
    const bool turns = arc == session.newArc;
    if (turns && !plan.canTurnAxis) continue;
    for (const SightingPlace& place : plan.places)
      for (const int face : plan.faces) {
        next.point = place.point;
        next.face = face;
        next.round = roundOf(before, turns || !found ? nullptr : &last, place.point, face);
        if (plan.readsSlider) next.slider = place.s;
        const double minutes = minutesOf(plan.minutes, {.turnsAxis = turns,
                                                        .sightsZero = turns,
                                                        .plungesTelescope = face != last.face,
                                                        .drivesSlider = turns || next.point != last.point});
        session.possible.push_back({arc,
                                    {.axisDeg = before.axisDeg,
                                     .point = next.point,
                                     .face = face,
                                     .round = next.round,
                                     .turnsAxis = turns,
                                     .minutes = minutes}});
        all.arcs[arc].sightings.push_back(next);
      }
  }
  all = withZerosSighted(std::move(all));
  return session;
}

void sightPossible(PossibleSightings& session, const SightingPlan& plan, const std::vector<Circle>& circles) {
  Measurement& measurement = session.measurement;
  for (std::size_t i = 0; i < measurement.arcs.size(); ++i) {
    ArcMeasurement& arc = measurement.arcs[i];
    const ZeroLine line(measurement, arc);
    for (std::size_t k = session.taken[i]; k < arc.sightings.size(); ++k) {
      Sighting& sighting = arc.sightings[k];
      if (sighting.isZero) continue;
      if (const Sighting* there = takenAt(arc, session.taken[i], sighting.point)) {
        sighting.a = there->a;
        sighting.e = there->e;
        if (sighting.slider && there->slider) sighting.slider = there->slider;
        continue;
      }
      const auto place = std::ranges::find(plan.places, sighting.point, &SightingPlace::point);
      const double phi = arcAngleOf(place->s.radians(), arc.axisDeg);
      const Direction<double> seen =
          line.observe(targetOnArc(circles[i].x, circles[i].y, circles[i].radius, phi));
      sighting.a = Angle::fromRadians(seen.a);
      sighting.e = Angle::fromRadians(seen.e);
      if (sighting.slider) sighting.slider = place->s;
    }
  }
}

}  // namespace alidade
