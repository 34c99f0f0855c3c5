#include "core/session/measurement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/threads.h"
#include "core/session/compensator.h"
#include "core/session/entry.h"
#include "core/session/instrument_record.h"
#include "core/session/position_examiner.h"
#include "core/session/problem_reporter.h"
#include "core/session/row_fields.h"
#include "core/session/row_order.h"
#include "core/session/session_fields.h"
#include "core/session/slider_sense.h"
#include "core/session/time_text.h"

namespace alidade {

namespace {

struct KnownOffset {
  double millimetres, sigma, correlation;
};

/// The offset of the line of sight, in mm, if none is stated. It is 0 ± 0.1 (1σ, from manufacturing) for a
/// collimation from an instrument check, which is made at other distances. Any other source is assumed to
/// state the collimation at the distance of the session; the offset is then 0.
KnownOffset defaultOffset(const KnownNumber& collimation) {
  constexpr double plausible = 0.1;
  const bool isChecked = collimation.from.find(fromInstrumentCheck) != std::string::npos;
  return {0, isChecked ? plausible : 0, 0};
}

/// The collimation c + e/D at the distance D in mm, in arcseconds, with u² = u_c² + (u_e/D)² + 2 ρ u_c u_e/D.
KnownNumber atDistance(KnownNumber collimation, const KnownOffset& offset, double distance) {
  if (offset.millimetres == 0 && offset.sigma == 0) return collimation;
  const double perMillimetre = Angle::fromRadians(1 / distance).arcseconds();
  const double change = offset.millimetres * perMillimetre, u = offset.sigma * perMillimetre;
  collimation.value += change;
  collimation.sigma = std::sqrt(std::max(
      0.0, collimation.sigma * collimation.sigma + u * u + 2 * offset.correlation * collimation.sigma * u));
  if (!collimation.from.empty()) collimation.from += "; ";
  collimation.from += "line of sight off by " + shortestText(offset.millimetres) + " ± " +
                      shortestText(offset.sigma) + " mm at " + shortestText(std::round(distance)) +
                      " mm added";
  return collimation;
}

/// Is a circle or slider reading typed in the position? Problems of a repeat not yet begun are not reported.
bool isBegun(const Position& position) {
  const auto isTyped = [](const ZeroSighting& zero) {
    return !zero.horizontal.empty() || !zero.vertical.empty();
  };
  return isTyped(firstSighting(position.zero)) ||
         std::ranges::any_of(furtherZeros,
                             [&](const ZeroSlot& slot) { return isTyped(position.zero.*slot.sighting); }) ||
         std::ranges::any_of(position.readings, [](const Reading& row) {
           return !row.horizontal.empty() || !row.vertical.empty() || !row.slider.empty();
         });
}

/// Examines a session in the order of its file.
class Examiner : private ProblemReporter {
 public:
  explicit Examiner(const Session& session) : m_session(session) {}

  Examined examine() {
    for (const SessionField& field : sessionFields()) {
      if (isDay(field.key)) checkDate(std::string(field.key), field.get(m_session));
      if (!field.isOfMeasurement && field.kind() == ValueKind::Number) number(field.key.data());
    }
    examineInstrument();
    const auto temperature = number("environment.temperature_c");
    const auto sigma = number("environment.sigma_temperature_c");
    examineGeometry();
    expand(temperature.value_or(std::nullopt), sigma && *sigma ? **sigma : 0);
    examineAcceptance();
    if (auto relation =
            take(verticalAngleEntry(m_session.model.verticalAngle), {.field = "model.vertical_angle"})) {
      m_measurement.relation = *relation;
    } else {
      m_usable = false;
    }
    if (auto radius = take(radiusModelEntry(m_session.model.radius), {.field = "model.radius"})) {
      m_measurement.radiusModel = *radius;
    } else {
      m_usable = false;
    }
    m_measurement.effects = m_session.model.effects;
    m_measurement.own = examineOwnEffects(m_session.ownEffects, m_problems);
    checkDate("instrument.record.date", m_session.instrument.record.date);
    examineKnown("instrument.known", m_session.instrument.known);
    takeLineOfSight();
    examineKnown("device.known", m_session.device.known);
    examinePositions();
    std::ranges::move(compensatorKnowledge(m_measurement).known, std::back_inserter(m_measurement.known));

    Examined examined;
    if (m_usable) examined.measurement = std::move(m_measurement);
    examined.problems = std::move(m_problems);
    return examined;
  }

 private:
  /// The entry's value; empty, with a problem reported, if it cannot be used. The inner optional is empty for
  /// an empty entry.
  std::optional<std::optional<double>> number(const char* field) {
    return take(numberEntry(field, sessionFieldNamed(field)->get(m_session)), {.field = field});
  }

  void checkDate(const std::string& field, const std::string& text) {
    if (const auto problem = dateProblem(text)) report(*problem, {.field = field});
  }

  /// A number without which there is no measurement; 0 if the entry is unusable.
  double vitalNumber(const char* field) {
    const auto value = number(field);
    if (!value) m_usable = false;
    return value && *value ? **value : 0;
  }

  void examineInstrument() {
    const Instrument& instrument = m_session.instrument;
    const auto sigma = [this](const char* field) { return Angle::fromArcseconds(vitalNumber(field)); };
    m_measurement.sigmaHorizontal = sigma("instrument.sigma_horizontal_arcsec");
    m_measurement.sigmaVertical = sigma("instrument.sigma_vertical_arcsec");
    const auto zero = number("instrument.sigma_zero_arcsec");
    if (!zero) m_usable = false;
    const bool stated = zero && *zero;
    const Angle sigmaZero = stated ? Angle::fromArcseconds(**zero) : Angle();
    m_measurement.zerosAreReadings = !stated;
    m_measurement.sigmaZeroHorizontal = stated ? sigmaZero : m_measurement.sigmaHorizontal;
    m_measurement.sigmaZeroVertical = stated ? sigmaZero : m_measurement.sigmaVertical;
    const auto unit = take(circleUnitEntry(instrument.angleUnit), {.field = "instrument.angle_unit"});
    if (unit) m_measurement.angleUnit = *unit;
    m_measurement.sigmaSlider = sigma("instrument.sigma_slider_arcsec");
    m_measurement.sigmaCompensator = sigma("instrument.sigma_compensator_arcsec");
  }

  void examineGeometry() {
    const Geometry& geometry = m_session.geometry;
    m_measurement.distance = vitalNumber("geometry.distance_mm");
    m_measurement.sigmaDistance = vitalNumber("geometry.sigma_distance_mm");
    m_measurement.nominalRadius = vitalNumber("geometry.radius_mm");
    m_measurement.sigmaRadius = vitalNumber("geometry.sigma_radius_mm");
    m_circle = take(verticalCircleEntry(geometry.verticalCircle), {.field = "geometry.vertical_circle"});
    if (m_circle) m_measurement.verticalCircle = *m_circle;
    m_usable = m_usable && m_circle;
    const auto zeros = take(pointingZerosEntry(geometry.pointingZeros), {.field = "geometry.pointing_zeros"});
    if (zeros) m_measurement.pointingZeros = *zeros;
    m_usable = m_usable && zeros;
    if (const auto plane = take(arcPlaneEntry(geometry.plane), {.field = "geometry.plane"}))
      m_measurement.plane = *plane;
    else
      m_usable = false;
    m_measurement.isPlaneStated = !geometry.plane.empty();
    if (const auto sighted = take(zeroIsEntry(geometry.zeroIs), {.field = "geometry.zero_is"}))
      m_measurement.zeroIs = *sighted;
    else
      m_usable = false;
  }

  /// Converts the lengths from 20 °C, for which they are stated, to the temperature of the session.
  void expand(const std::optional<double>& temperature, double sigmaTemperature) {
    const auto toTemperature = [&](const char* field, double& length, double& sigma) {
      constexpr double reference = 20, millionth = 1e-6;
      const auto coefficient = number(field);
      if (!coefficient) m_usable = false;
      if (!coefficient || **coefficient == 0) return 0.0;
      if (!temperature) {
        report({Phrase::of(
                   "has no effect without a temperature: type the temperature, or clear the coefficient")},
               {.field = field});
        return 0.0;
      }
      const double perKelvin = length * **coefficient * millionth;
      const double change = perKelvin * (*temperature - reference);
      length += change;
      sigma = std::hypot(sigma, perKelvin * sigmaTemperature);
      return change;
    };
    m_measurement.distanceExpansion = toTemperature("geometry.distance_expansion_ppm_per_k",
                                                    m_measurement.distance, m_measurement.sigmaDistance);
    m_measurement.radiusExpansion = toTemperature("geometry.radius_expansion_ppm_per_k",
                                                  m_measurement.nominalRadius, m_measurement.sigmaRadius);
  }

  void examineAcceptance() {
    const Acceptance& acceptance = m_session.acceptance;
    const auto tolerance = number("acceptance.tolerance_mm");
    const auto coverage = number("acceptance.coverage");
    const auto measurand = take(measurandEntry(acceptance.measurand), {.field = "acceptance.measurand"});
    const auto reference = number("acceptance.reference_intersection_mm");
    const auto sigmaReference = number("acceptance.sigma_reference_mm");
    m_measurement.tolerance = coverage && measurand ? tolerance.value_or(std::nullopt) : std::nullopt;
    if (measurand) m_measurement.measurand = *measurand;
    if (coverage) m_measurement.coverage = coverage->value_or(m_measurement.coverage);
    m_measurement.referenceIntersection = reference.value_or(std::nullopt);
    if (m_measurement.referenceIntersection)
      m_measurement.sigmaReference = sigmaReference.value_or(std::nullopt);
  }

  void examineKnown(const std::string& list, const std::vector<KnownSize>& known) {
    for (std::size_t i = 0; i < known.size(); ++i) {
      const KnownSize& size = known[i];
      const std::string entry = list + "[" + std::to_string(i) + "]";
      const auto value = take(knownValueEntry(size.value), {.field = entry + ".value"});
      const auto sigma = take(knownSigmaEntry(size.sigma), {.field = entry + ".sigma"});
      checkDate(entry + ".date", size.date);
      if (value && sigma)
        m_measurement.known.push_back(
            {{.field = entry}, size.effect, size.parameter, size.unit, size.from, size.date, *value, *sigma});
    }
  }

  /// Adds e/D at the distance of the slider to the collimation. The distance is known well enough: an error
  /// of 1 % changes e/D by a hundredth.
  void takeLineOfSight() {
    const auto offset = number("instrument.line_of_sight_mm");
    const auto sigma = number("instrument.sigma_line_of_sight_mm");
    const auto correlation = number("instrument.line_of_sight_correlation");
    const double distance = std::hypot(m_measurement.distance, m_measurement.nominalRadius);
    if (!offset || !sigma || !correlation || !(distance > 0)) return;
    for (KnownNumber& known : m_measurement.known)
      if (known.effect == "collimation" && known.unit == "arcsec")
        known = atDistance(
            known, *offset ? KnownOffset{**offset, **sigma, **correlation} : defaultOffset(known), distance);
  }

  /// Long positions are examined in parallel; problems are reported in file order.
  void examinePositions() {
    const std::vector<Position>& positions = m_session.positions;
    const std::vector<std::size_t> firsts = firstSequences(m_session);
    const ExaminedZeros zeros = zerosOf();
    std::vector<ExaminedPosition> examined(positions.size());
    for (const Position& position : positions) m_measurement.rows += position.readings.size();
    doEach(threadsFor(m_measurement.rows), positions.size(), [&](std::size_t i) {
      examined[i] = examinePosition(positions[i], i, firsts[i], zeros.ofPositions[i], m_circle);
    });
    std::vector<std::optional<ArcMeasurement>> arcs(positions.size());
    std::map<int, int> repeats;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Place place{.position = i, .field = "axis_deg"};
      const std::optional<int> axis = take(axisEntry(positions[i].axisDeg), place);
      const int repeat = axis ? ++repeats[*axis] : 1;
      ExaminedPosition& own = examined[i];
      if (repeat == 1 || isBegun(positions[i]))
        std::ranges::move(own.problems, std::back_inserter(m_problems));
      const auto& zero = zeros.ofPositions[i].direction;
      if (axis && zero)
        arcs[i] = {i,
                   *axis,
                   zero->horizontal,
                   zero->vertical,
                   std::move(own.sightings),
                   repeat,
                   zero->sightings,
                   zero->each,
                   zeroElevation(zero->vertical, m_measurement.verticalCircle).value_or(Angle())};
    }
    for (const std::size_t i : positionsAsTaken(m_session))
      if (arcs[i]) m_measurement.arcs.push_back(*std::move(arcs[i]));
    for (ArcMeasurement& arc : m_measurement.arcs) checkSense(arc);
    setMoments(m_measurement);
  }

  /// Leaves out slider readings that run the other way: no zero of the scale fits them.
  void checkSense(ArcMeasurement& arc) {
    if (!runsAgainstSlider(arc)) return;
    for (Sighting& row : arc.sightings) row.slider.reset();
    report({Phrase::of(
               "the slider readings decrease where the slider coordinate s increases (at 0° with the arc "
               "angle, at 180° against it): enter them with the opposite sign, or leave them out")},
           {.position = arc.position, .field = "readings"});
  }

  /// Examines the zeros. Different zeros are a problem if one zero for all positions is stated.
  ExaminedZeros zerosOf() {
    ExaminedZeros zeros = examineZeros(m_session, m_circle, m_measurement.pointingZeros,
                                       m_measurement.sigmaZeroHorizontal, m_measurement.sigmaZeroVertical);
    m_measurement.zeroScatter = zeros.scatter;
    if (!zeros.isOneOfSeveral) return zeros;
    m_measurement.pointingZeros = PointingZeros::Each;
    report({Phrase::of("is stated as “one”, but the positions have different zeros: give all the same α0 and "
                       "β0, or state “each”")},
           {.field = "geometry.pointing_zeros"});
    return zeros;
  }

  const Session& m_session;
  Measurement m_measurement;
  bool m_usable = true;
  std::optional<VerticalCircle> m_circle;
};

}  // namespace

namespace {

/// Moments of the rows of a session, as shares of its duration.
class Clock {
 public:
  explicit Clock(const Measurement& measurement)
      : m_pause(measurement.pauseRows),
        m_length(static_cast<double>(measurement.rows) - 1 +
                 m_pause * (static_cast<double>(measurement.arcs.size()) - 1)),
        m_isTimed(hasTimes(measurement)) {
    if (!m_isTimed) return;
    for (const ArcMeasurement& arc : measurement.arcs)
      for (const Sighting& sighting : arc.sightings) {
        m_first = std::min(m_first, *sighting.minutes);
        m_last = std::max(m_last, *sighting.minutes);
      }
    m_isTimed = m_last > m_first;
  }

  /// The moment of a row of the `arc`-th arc.
  double at(const Sighting& sighting, std::size_t arc) const {
    if (m_isTimed) return share(*sighting.minutes);
    const double since = static_cast<double>(sighting.sequence) + m_pause * static_cast<double>(arc);
    return m_length > 0 ? since / m_length : 0;
  }
  double at(const SightedZero& zero, double momentOfRow) const {
    return m_isTimed && zero.minutes ? share(*zero.minutes) : momentOfRow;
  }

 private:
  double share(double minutes) const { return (minutes - m_first) / (m_last - m_first); }

  double m_pause, m_length;  ///< pause between positions and length of the session, in rows
  double m_first = std::numeric_limits<double>::infinity(), m_last = -m_first;
  bool m_isTimed;
};

/// The mean moment of the sightings of a zero, with both faces weighted equally.
double meanMoment(const std::vector<SightedZero>& sightings) {
  double sum = 0;
  int faces = 0;
  for (const int face : {1, 2}) {
    double ofFace = 0;
    int count = 0;
    for (const SightedZero& zero : sightings) {
      if (zero.face != face) continue;
      ofFace += zero.elapsed;
      ++count;
    }
    if (count == 0) continue;
    sum += ofFace / count;
    ++faces;
  }
  return faces > 0 ? sum / faces : 0;
}

/// The sightings of each arc's zero. For a common zero, the sightings before the readings belong to the first
/// arc, those after them to the last.
std::vector<std::vector<SightedZero>> zeroSightingsByArc(const Measurement& measurement) {
  std::vector<std::vector<SightedZero>> zeros;
  for (const ArcMeasurement& arc : measurement.arcs) zeros.push_back(arc.zeroSightings);
  if (!measurement.hasOneZero() || zeros.size() < 2) return zeros;
  for (std::size_t arc = 0; arc < zeros.size(); ++arc)
    std::erase_if(zeros[arc],
                  [&](const SightedZero& zero) { return arc != (zero.isAfter ? zeros.size() - 1 : 0); });
  return zeros;
}

}  // namespace

bool hasTimes(const Measurement& measurement) {
  return std::ranges::all_of(measurement.arcs, [](const ArcMeasurement& arc) {
    return std::ranges::all_of(arc.sightings, [](const Sighting& s) { return s.isZero || s.minutes; });
  });
}

void setMoments(Measurement& measurement) {
  const Clock clock(measurement);
  std::vector<std::vector<SightedZero>> zeros = zeroSightingsByArc(measurement);
  std::vector<double> beginnings;  // moments of the positions' first rows
  std::size_t zerosBefore = 0;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    ArcMeasurement& arc = measurement.arcs[i];
    const auto [first, last] = std::ranges::minmax_element(arc.sightings, {}, &Sighting::sequence);
    const bool hasRows = first != arc.sightings.end();
    const auto number = [&](bool isAfter, std::size_t row, double elapsed) {
      for (SightedZero& zero : zeros[i]) {
        if (zero.isAfter != isAfter) continue;
        zero.order = row + zerosBefore++;
        zero.elapsed = clock.at(zero, elapsed);
      }
    };
    beginnings.push_back(hasRows ? clock.at(*first, i) : 0);
    number(false, hasRows ? first->sequence : 0, beginnings.back());
    for (Sighting& sighting : arc.sightings) {
      sighting.order = sighting.sequence + zerosBefore;
      sighting.elapsed = clock.at(sighting, i);
    }
    number(true, hasRows ? last->sequence + 1 : 0, hasRows ? clock.at(*last, i) : 0);
  }
  std::vector<SightedZero> all;
  for (const auto& own : zeros) all.insert(all.end(), own.begin(), own.end());
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const std::vector<SightedZero>& own = measurement.hasOneZero() ? all : zeros[i];
    measurement.arcs[i].zero.elapsed =
        own.empty() ? beginnings[measurement.hasOneZero() ? 0 : i] : meanMoment(own);
    measurement.arcs[i].zeroSightings = std::move(zeros[i]);
  }
}

std::vector<std::size_t> firstAtTheirAxes(const Measurement& measurement) {
  std::vector<std::size_t> firsts;
  for (const ArcMeasurement& arc : measurement.arcs) {
    const auto first = std::ranges::find(measurement.arcs, arc.axisDeg, &ArcMeasurement::axisDeg);
    firsts.push_back(static_cast<std::size_t>(first - measurement.arcs.begin()));
  }
  return firsts;
}

namespace {

bool haveSameZero(const ArcMeasurement& one, const ArcMeasurement& other) {
  return areEqualAsTyped(one.zeroHorizontal, other.zeroHorizontal) &&
         areEqualAsTyped(one.zeroVertical, other.zeroVertical);
}

auto arcsAt(const Measurement& measurement, int axisDeg) {
  return std::ranges::count(measurement.arcs, axisDeg, &ArcMeasurement::axisDeg);
}

}  // namespace

bool hasRepeats(const Measurement& measurement) {
  return arcsAt(measurement, 0) > 1 || arcsAt(measurement, 180) > 1;
}

bool hasAlikeZeros(const Measurement& measurement) {
  const std::vector<ArcMeasurement>& arcs = measurement.arcs;
  return arcs.size() > 1 && std::ranges::all_of(arcs, [&](const ArcMeasurement& arc) {
           return haveSameZero(arc, arcs.front());
         });
}

bool hasBothAxes(const Measurement& measurement) {
  return arcsAt(measurement, 0) > 0 && arcsAt(measurement, 180) > 0;
}

Examined examine(const Session& session) {
  return Examiner(session).examine();
}

}  // namespace alidade
