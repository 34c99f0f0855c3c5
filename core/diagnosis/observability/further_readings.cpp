#include "core/diagnosis/observability/further_readings.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/adjustment/joint/sighted_zeros.h"
#include "core/effects/catalogue.h"
#include "core/observation/half_turn.h"
#include "core/observation/observe.h"
#include "core/observation/visits.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

double arcAngle(const GapModel& model, std::size_t arc, std::size_t sighting) {
  return model.fit->arcAngles[arc][sighting];
}

/// The fitted size of a term with a bent effect, in the unit of the term; 0 for any other term.
double plannedSize(const GapModel& model, ErrorTerm term) {
  const Effect* effect = effectOf(term, *model.measurement);  // null for the term of a jump
  if (!effect || effect->response != Response::Bent) return 0;
  return model.fit->values[model.fit->indexOf(term)];
}

/// Gives the sightings of a plan their readings: free of error, at places on the fitted circles, which the
/// fitted bent effects displace.
class PlannedReadings {
 public:
  explicit PlannedReadings(const GapModel& model) : m_model(model) {
    for (const EstimatedTerm& term : model.options.terms)
      if (const double size = plannedSize(model, term.term); size != 0) m_bends.set(term.term, size);
  }

  /// `arc`: index in the plan and in the model.
  void sight(Sighting& sighting, const Measurement& plan, std::size_t arc, double phi) const {
    const Circle circle = m_model.fit->circleOf(arc);
    const ArcPose<double> pose{circle.x, circle.y, circle.radius, 0, 0, 0};
    const ArcMeasurement& own = plan.arcs[arc];
    const Direction<double> seen =
        ZeroLine(plan, own).observeInSpace(targetAt(m_bends, pose, plan.distance, phi, own.axisDeg));
    sighting.a = Angle::fromRadians(seen.a);
    sighting.e = Angle::fromRadians(seen.e);
  }

 private:
  const GapModel& m_model;
  ErrorTerms<double> m_bends;
};

/// Numbers the rows consecutively in their current order.
void renumber(Measurement& plan) {
  plan.rows = 0;
  for (ArcMeasurement& arc : plan.arcs)
    for (Sighting& sighting : arc.sightings) {
      sighting.sequence = plan.rows++;
      sighting.minutes.reset();
    }
  setMoments(plan);
}

FurtherReadings further(Measure measure, Measurement more) {
  if (more.sightedZeros) putInZeros(more);
  FurtherReadings readings{{measure}, {}};
  readings.sets.push_back(std::move(more));
  return readings;
}

/// Returns the session together with a further set-up.
FurtherReadings withFurtherSetUp(const Measurement& session, Measure measure, Measurement more) {
  FurtherReadings readings = further(measure, session);
  if (more.sightedZeros) putInZeros(more);
  readings.sets.push_back(std::move(more));
  readings.includesSession = true;
  return readings;
}

/// Marks the rows of visits with sightings in both faces.
std::vector<bool> rowsInBothFaces(const ArcMeasurement& arc) {
  std::vector<bool> rows(arc.sightings.size());
  for (const Visit& visit : visitsOf(arc))
    if (visit.sightings.size() > 1)
      for (const std::size_t row : visit.sightings) rows[row] = true;
  return rows;
}

std::optional<FurtherReadings> withBothFaces(Measurement more) {
  bool added = false;
  for (ArcMeasurement& arc : more.arcs) {
    const std::vector<bool> inBothFaces = rowsInBothFaces(arc);
    std::vector<Sighting> rows;
    rows.reserve(2 * arc.sightings.size());
    for (std::size_t i = 0; i < arc.sightings.size(); ++i) {
      rows.push_back(arc.sightings[i]);
      if (inBothFaces[i]) continue;
      rows.push_back(arc.sightings[i]);
      rows.back().face = 3 - rows.back().face;
      added = true;
    }
    arc.sightings = std::move(rows);
  }
  if (!added) return std::nullopt;
  renumber(more);
  return further(Measure::BothFaces, std::move(more));
}

std::optional<FurtherReadings> withWayBack(Measurement more) {
  for (ArcMeasurement& arc : more.arcs) {
    int rounds = 1;
    for (const Sighting& sighting : arc.sightings) rounds = std::max(rounds, sighting.round);
    if (rounds > 1) return std::nullopt;
    std::vector<Sighting> back(arc.sightings.rbegin(), arc.sightings.rend());
    for (Sighting& sighting : back) sighting.round = rounds + 1;
    arc.sightings.insert(arc.sightings.end(), back.begin(), back.end());
  }
  renumber(more);
  return further(Measure::WayBack, std::move(more));
}

std::optional<FurtherReadings> withSlider(const GapModel& model, Measurement more) {
  bool added = false;
  for (std::size_t arc = 0; arc < more.arcs.size(); ++arc)
    for (std::size_t i = 0; i < more.arcs[arc].sightings.size(); ++i) {
      Sighting& sighting = more.arcs[arc].sightings[i];
      if (sighting.slider) continue;
      const double phi = arcAngle(model, arc, i);
      sighting.slider = Angle::fromRadians(sliderCoordinateOf(phi, more.arcs[arc].axisDeg));
      added = true;
    }
  if (!added) return std::nullopt;
  return further(Measure::SliderReadings, std::move(more));
}

std::optional<FurtherReadings> withShiftedCircle(const Measurement& plan) {
  Measurement more = plan;
  for (ArcMeasurement& arc : more.arcs) arc.zeroHorizontal = arc.zeroHorizontal + Angle::fromDegrees(60);
  return withFurtherSetUp(plan, Measure::ShiftedCircle, std::move(more));
}

std::optional<FurtherReadings> withSecondStandOff(const GapModel& model, const Measurement& plan) {
  constexpr double farther = 1.5;
  Measurement more = plan;
  more.distance *= farther;
  const PlannedReadings planned(model);
  for (std::size_t arc = 0; arc < more.arcs.size(); ++arc)
    for (std::size_t i = 0; i < more.arcs[arc].sightings.size(); ++i)
      planned.sight(more.arcs[arc].sightings[i], more, arc, arcAngle(model, arc, i));
  return withFurtherSetUp(plan, Measure::SecondStandOff, std::move(more));
}

/// The sightings of a place in the rounds and faces in which at least half the places are sighted, else one
/// in face 1; with a slider reading if at least half the sightings have one.
std::vector<Sighting> usualSightings(const ArcMeasurement& arc) {
  std::map<std::pair<int, int>, std::set<int>> pointsOf;  // by round and face
  std::set<int> points;
  for (const Sighting& sighting : arc.sightings) {
    pointsOf[{sighting.round, sighting.face}].insert(sighting.point);
    points.insert(sighting.point);
  }
  const auto read = std::ranges::count_if(arc.sightings, [](const Sighting& one) { return !!one.slider; });
  std::vector<Sighting> usual;
  for (const auto& [pass, there] : pointsOf) {
    if (2 * there.size() < points.size()) continue;
    Sighting& sighting = usual.emplace_back();
    sighting.round = pass.first;
    sighting.face = pass.second;
    if (2 * read >= std::ssize(arc.sightings)) sighting.slider = Angle();
  }
  if (usual.empty()) usual.emplace_back();
  return usual;
}

std::optional<FurtherReadings> withMoreArc(const GapModel& model, Measurement more) {
  constexpr double enough = 150, whole = 160;  // degrees
  constexpr int points = 17;
  bool added = false;
  const PlannedReadings planned(model);
  for (std::size_t arc = 0; arc < more.arcs.size(); ++arc) {
    const auto rows = std::span(model.fit->arcAngles[arc]).first(more.arcs[arc].sightings.size());
    const auto [least, most] = std::ranges::minmax(rows);  // zeros, which follow the rows, have no place
    if ((most - least) * 180 / std::numbers::pi > enough) continue;
    int point = 0;
    for (const Sighting& sighting : more.arcs[arc].sightings) point = std::max(point, sighting.point);
    const std::vector<Sighting> pass = usualSightings(more.arcs[arc]);
    for (int k = 0; k < points; ++k) {
      const double s = (90 - whole / 2 + whole * k / (points - 1)) * std::numbers::pi / 180;
      const double phi = arcAngleOf(s, more.arcs[arc].axisDeg);
      if (phi >= least && phi <= most) continue;
      ++point;
      for (Sighting sighting : pass) {
        sighting.point = point;
        planned.sight(sighting, more, arc, phi);
        if (sighting.slider) sighting.slider = Angle::fromRadians(s);
        more.arcs[arc].sightings.push_back(sighting);
      }
      added = true;
    }
  }
  if (!added) return std::nullopt;
  renumber(more);
  return further(Measure::MoreOfTheArc, std::move(more));
}

/// Repeats the visits of the position at `axisDeg` at the end of the plan. Drifts continue.
std::optional<FurtherReadings> withPositionAgain(const Measurement& plan, int axisDeg) {
  const auto first = arcAt(plan, axisDeg);
  if (!first || std::ranges::count(plan.arcs, axisDeg, &ArcMeasurement::axisDeg) > 1) return std::nullopt;
  Measurement more = plan;
  ArcMeasurement again = plan.arcs[*first];
  ++again.repeat;
  std::size_t next = plan.rows;
  for (const ArcMeasurement& arc : plan.arcs)
    for (const Sighting& sighting : arc.sightings) next = std::max(next, sighting.sequence + 1);
  for (Sighting& sighting : again.sightings) {
    sighting.sequence = next++;
    sighting.minutes.reset();
  }
  more.arcs.push_back(std::move(again));
  setMoments(more);
  FurtherReadings readings = further(axisDeg == 0 ? Measure::At0Again : Measure::At180Again, std::move(more));
  readings.goesOn = true;
  return readings;
}

/// Adds a measure to the plan `first`. Absent if `first` is absent or the measure cannot be added.
template <typename Add>
std::optional<FurtherReadings> together(std::optional<FurtherReadings> first, const Add& add) {
  if (!first) return std::nullopt;
  leaveOutZeros(first->sets.back());
  std::optional<FurtherReadings> both = add(std::move(first->sets.back()));
  if (both) both->measures.insert(both->measures.begin(), first->measures.begin(), first->measures.end());
  return both;
}

auto offering(const std::function<void(const FurtherReadings&)>& take) {
  return [&take](const std::optional<FurtherReadings>& more) {
    if (more) take(*more);
  };
}

/// Returns the rows and zeros without error. Sightings of zeros are missing: they are added when all rows are
/// known.
Measurement rowsWithoutError(const GapModel& model) {
  Measurement plan = *model.measurement;
  leaveOutZeros(plan);
  const PlannedReadings planned(model);
  for (std::size_t arc = 0; arc < plan.arcs.size(); ++arc) {
    for (SightedZero& zero : plan.arcs[arc].zeroSightings) zero.a = zero.e = Angle();
    for (std::size_t i = 0; i < plan.arcs[arc].sightings.size(); ++i) {
      Sighting& sighting = plan.arcs[arc].sightings[i];
      const double phi = arcAngle(model, arc, i);
      planned.sight(sighting, plan, arc, phi);
      if (sighting.slider)
        sighting.slider = Angle::fromRadians(sliderCoordinateOf(phi, plan.arcs[arc].axisDeg));
    }
  }
  return plan;
}

}  // namespace

EstimatedTerm asPlanned(EstimatedTerm term, const GapModel& model) {
  term.start = term.priorValue = plannedSize(model, term.term);
  return term;
}

Measurement readWithoutError(const GapModel& model) {
  Measurement plan = rowsWithoutError(model);
  if (plan.sightedZeros) putInZeros(plan);
  return plan;
}

void eachFurtherReadings(const GapModel& model, const std::function<void(const FurtherReadings&)>& take) {
  const Measurement plan = rowsWithoutError(model);
  const auto offer = offering(take);
  offer(withBothFaces(plan));
  offer(withWayBack(plan));
  offer(withSlider(model, plan));
  offer(withShiftedCircle(plan));
  offer(withSecondStandOff(model, plan));
  offer(withMoreArc(model, plan));
  if (hasBothAxes(plan))
    for (const int axisDeg : {0, 180}) offer(withPositionAgain(plan, axisDeg));
}

/// Plans of a million rows fill hundreds of megabytes, so each plan is released after its use.
void eachCombination(const GapModel& model, const std::function<void(const FurtherReadings&)>& take) {
  const auto offer = offering(take);
  offer(together(withBothFaces(rowsWithoutError(model)), withWayBack));
  auto slider = withSlider(model, rowsWithoutError(model));
  offer(together(slider, withBothFaces));
  offer(together(slider, withWayBack));
  auto both = together(std::move(slider), withBothFaces);
  offer(together(std::move(both), withWayBack));
  constexpr std::size_t manyRows = 100'000;  // twice as many fill the memory and add no information about a
                                             // zero
  if (hasBothAxes(*model.measurement) && model.measurement->rows < manyRows)
    offer(together(withPositionAgain(rowsWithoutError(model), 0),
                   [](const Measurement& more) { return withPositionAgain(more, 180); }));
}

void linearisePlan(const GapModel& model, const Measurement& set, const std::vector<ErrorTerm>& terms,
                   const std::function<void(const Linearised& piece)>& take) {
  std::vector<Circle> circles;
  for (const ArcMeasurement& arc : set.arcs)
    circles.push_back(model.fit->circleOf(arcAt(*model.measurement, arc.axisDeg).value()));
  JointFitOptions options;
  options.isClosed = model.options.isClosed;
  for (const EstimatedTerm& term : model.options.terms) options.terms.push_back(asPlanned(term, model));
  linearise(set, circles, options, terms, take);
}

}  // namespace alidade
