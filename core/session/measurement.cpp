#include "core/session/measurement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/threads.h"
#include "core/session/compensator.h"
#include "core/session/entry.h"
#include "core/session/instrument_record.h"
#include "core/session/position_examiner.h"
#include "core/session/problem_reporter.h"
#include "core/session/row_order.h"

namespace alidade {

namespace {

struct KnownOffset {
  double millimetres, sigma, correlation;
};

/// Mechanics keep the line of sight within 0.1 mm of the axis (1σ). The collimation of a check at other
/// distances may hold as much; any other source is believed to state that of these distances.
KnownOffset offsetBeside(const KnownNumber& collimation) {
  constexpr double plausible = 0.1;
  const bool isChecked = collimation.from.find(fromInstrumentCheck) != std::string::npos;
  return {0, isChecked ? plausible : 0, 0};
}

/// c + e/D, in arcseconds, with u² = u_c² + (u_e/D)² + 2 ρ u_c u_e/D. D in mm.
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

/// Goes through a session in the order of its file.
class Examiner : private ProblemReporter {
 public:
  explicit Examiner(const Session& session) : m_session(session) {}

  Examined examine() {
    checkDate("measured_on", m_session.measuredOn);
    examineInstrument();
    const auto temperature = number("environment.temperature_c", m_session.environment.temperatureC);
    const auto sigma = number("environment.sigma_temperature_c", m_session.environment.sigmaTemperatureC);
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
  /// The entry's value; empty, and reported, where it cannot be used. The inner optional is an entry left
  /// empty.
  std::optional<std::optional<double>> number(const std::string& field, const std::string& text) {
    return take(numberEntry(field, text), {.field = field});
  }

  void checkDate(const std::string& field, const std::string& text) {
    if (const auto problem = dateProblem(text)) report(*problem, {.field = field});
  }

  /// Without this number there is no measurement.
  double vitalNumber(const std::string& field, const std::string& text) {
    const auto value = number(field, text);
    if (!value) m_usable = false;
    return value && *value ? **value : 0;
  }

  void examineInstrument() {
    const Instrument& instrument = m_session.instrument;
    const auto sigma = [this](const char* field, const std::string& text) {
      return Angle::fromArcseconds(vitalNumber(field, text));
    };
    m_measurement.sigmaHorizontal =
        sigma("instrument.sigma_horizontal_arcsec", instrument.sigmaHorizontalArcsec);
    m_measurement.sigmaVertical = sigma("instrument.sigma_vertical_arcsec", instrument.sigmaVerticalArcsec);
    const auto zero = number("instrument.sigma_zero_arcsec", instrument.sigmaZeroArcsec);
    if (!zero) m_usable = false;
    const bool stated = zero && *zero;
    const Angle sigmaZero = stated ? Angle::fromArcseconds(**zero) : Angle();
    m_measurement.zerosAreReadings = !stated;
    m_measurement.sigmaZeroHorizontal = stated ? sigmaZero : m_measurement.sigmaHorizontal;
    m_measurement.sigmaZeroVertical = stated ? sigmaZero : m_measurement.sigmaVertical;
    const auto unit = take(circleUnitEntry(instrument.angleUnit), {.field = "instrument.angle_unit"});
    if (unit) m_measurement.angleUnit = *unit;
    m_measurement.sigmaSlider = sigma("instrument.sigma_slider_arcsec", instrument.sigmaSliderArcsec);
    m_measurement.sigmaCompensator =
        sigma("instrument.sigma_compensator_arcsec", instrument.sigmaCompensatorArcsec);
  }

  void examineGeometry() {
    const Geometry& geometry = m_session.geometry;
    m_measurement.distance = vitalNumber("geometry.distance_mm", geometry.distanceMm);
    m_measurement.sigmaDistance = vitalNumber("geometry.sigma_distance_mm", geometry.sigmaDistanceMm);
    m_measurement.nominalRadius = vitalNumber("geometry.radius_mm", geometry.radiusMm);
    m_measurement.sigmaRadius = vitalNumber("geometry.sigma_radius_mm", geometry.sigmaRadiusMm);
    m_circle = take(verticalCircleEntry(geometry.verticalCircle), {.field = "geometry.vertical_circle"});
    if (m_circle) m_measurement.verticalCircle = *m_circle;
    m_usable = m_usable && m_circle;
    const auto zeros = take(pointingZerosEntry(geometry.pointingZeros), {.field = "geometry.pointing_zeros"});
    if (zeros) m_measurement.pointingZeros = *zeros;
    m_usable = m_usable && zeros;
  }

  /// From 20 °C, for which the lengths are stated, to the temperature of the session.
  void expand(const std::optional<double>& temperature, double sigmaTemperature) {
    const Geometry& geometry = m_session.geometry;
    const auto toTemperature = [&](const char* field, const std::string& text, double& length,
                                   double& sigma) {
      constexpr double reference = 20, millionth = 1e-6;
      const auto coefficient = number(field, text);
      if (!coefficient) m_usable = false;
      if (!coefficient || **coefficient == 0) return 0.0;
      if (!temperature) {
        report(
            {Phrase::of("has nothing to act on: type the temperature (environment.temperature_c), or clear "
                        "the coefficient")},
            {.field = field});
        return 0.0;
      }
      const double perKelvin = length * **coefficient * millionth;
      const double change = perKelvin * (*temperature - reference);
      length += change;
      sigma = std::hypot(sigma, perKelvin * sigmaTemperature);
      return change;
    };
    m_measurement.distanceExpansion =
        toTemperature("geometry.distance_expansion_ppm_per_k", geometry.distanceExpansionPpmPerK,
                      m_measurement.distance, m_measurement.sigmaDistance);
    m_measurement.radiusExpansion =
        toTemperature("geometry.radius_expansion_ppm_per_k", geometry.radiusExpansionPpmPerK,
                      m_measurement.nominalRadius, m_measurement.sigmaRadius);
  }

  void examineAcceptance() {
    const Acceptance& acceptance = m_session.acceptance;
    const auto tolerance = number("acceptance.tolerance_mm", acceptance.toleranceMm);
    const auto coverage = number("acceptance.coverage", acceptance.coverage);
    const auto measurand = take(measurandEntry(acceptance.measurand), {.field = "acceptance.measurand"});
    const auto reference = number("acceptance.reference_intersection_mm", acceptance.referenceIntersectionMm);
    const auto sigmaReference = number("acceptance.sigma_reference_mm", acceptance.sigmaReferenceMm);
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

  /// At the distance of the slider e/D is a part of the collimation. The distance is known well enough: an
  /// error of 1 % is a hundredth of e/D.
  void takeLineOfSight() {
    const LineOfSight& entered = m_session.instrument.lineOfSight;
    const auto offset = number("instrument.line_of_sight_mm", entered.offsetMm);
    const auto sigma = number("instrument.sigma_line_of_sight_mm", entered.sigmaMm);
    const auto correlation = number("instrument.line_of_sight_correlation", entered.correlation);
    const double distance = std::hypot(m_measurement.distance, m_measurement.nominalRadius);
    if (!offset || !sigma || !correlation || !(distance > 0)) return;
    for (KnownNumber& known : m_measurement.known)
      if (known.effect == "collimation" && known.unit == "arcsec")
        known = atDistance(
            known, *offset ? KnownOffset{**offset, **sigma, **correlation} : offsetBeside(known), distance);
  }

  /// Positions at once where they are long; what is wrong with them, in the order of the file.
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
    std::map<int, int> times;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Place place{.position = i, .field = "axis_deg"};
      const std::optional<int> axis = take(axisEntry(positions[i].axisDeg), place);
      const int time = axis ? ++times[*axis] : 1;
      ExaminedPosition& own = examined[i];
      std::ranges::move(own.problems, std::back_inserter(m_problems));
      const auto& zero = zeros.ofPositions[i].direction;
      if (axis && zero)
        arcs[i] = {i,    *axis,          zero->horizontal, zero->vertical, std::move(own.sightings),
                   time, zero->sightings};
    }
    for (const std::size_t i : positionsAsTaken(m_session))
      if (arcs[i]) m_measurement.arcs.push_back(*std::move(arcs[i]));
  }

  /// Zeros that differ are not one.
  ExaminedZeros zerosOf() {
    ExaminedZeros zeros = examineZeros(m_session, m_circle, m_measurement.pointingZeros,
                                       m_measurement.sigmaZeroHorizontal, m_measurement.sigmaZeroVertical);
    m_measurement.zeroScatter = zeros.scatter;
    if (!zeros.isOneOfSeveral) return zeros;
    m_measurement.pointingZeros = PointingZeros::Each;
    report(
        {Phrase::of("is stated as one, but the positions have different zeros: give all of them the same α0 "
                    "and β0, or state each")},
        {.field = "geometry.pointing_zeros"});
    return zeros;
  }

  const Session& m_session;
  Measurement m_measurement;
  bool m_usable = true;
  std::optional<VerticalCircle> m_circle;
};

}  // namespace

std::vector<std::size_t> firstAtTheirAxes(const Measurement& measurement) {
  std::vector<std::size_t> firsts;
  for (const ArcMeasurement& arc : measurement.arcs) {
    const auto first = std::ranges::find(measurement.arcs, arc.axisDeg, &ArcMeasurement::axisDeg);
    firsts.push_back(static_cast<std::size_t>(first - measurement.arcs.begin()));
  }
  return firsts;
}

namespace {

/// Up to how their texts are written.
bool haveSameZero(const ArcMeasurement& one, const ArcMeasurement& other) {
  constexpr double rounding = 1e-6;  // arcsec
  const auto areAlike = [](Angle a, Angle b) { return std::abs(wrapped(a - b).arcseconds()) < rounding; };
  return areAlike(one.zeroHorizontal, other.zeroHorizontal) && areAlike(one.zeroVertical, other.zeroVertical);
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
