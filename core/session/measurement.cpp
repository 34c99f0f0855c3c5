#include "core/session/measurement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/row_order.h"

namespace alidade {

namespace {

/// Further from the pointing zero than this nothing on the arc is sighted: the tangents grow beyond sense.
constexpr double widestDegrees = 80;

/// The pointing zero of one position, α0 and β0 of face 1.
struct ZeroDirection {
  Angle horizontal, vertical;
};

/// What no two rows of a position have in common.
struct VisitFace {
  int round, point, face;

  bool operator==(const VisitFace&) const = default;
};

struct HashOfVisitFace {
  std::size_t operator()(const VisitFace& key) const {
    const auto part = [](int number) {
      return static_cast<std::uint64_t>(static_cast<std::uint32_t>(number));
    };
    const std::uint64_t sum = (part(key.point) << 32U | part(key.round)) * 2 + part(key.face);
    return static_cast<std::size_t>((sum ^ sum >> 31U) * 0x9e3779b97f4a7c15U);
  }
};

bool isUntouched(const Reading& reading) {
  return reading.point.empty() && reading.round.empty() && reading.face.empty() &&
         reading.horizontal.empty() && reading.vertical.empty() && reading.slider.empty() &&
         reading.note.empty();
}

/// Goes through a session in the order of its file.
class Examiner {
 public:
  explicit Examiner(const Session& session) : m_session(session), m_firstSequences(firstSequences(session)) {}

  Examined examine() {
    if (auto problem = dateProblem(m_session.measuredOn)) report(*problem, {.field = "measured_on"});
    examineInstrument();
    number("environment.temperature_c", m_session.environment.temperatureC);
    examineGeometry();
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
    examinePositions();

    Examined examined;
    if (m_usable) examined.measurement = std::move(m_measurement);
    examined.problems = std::move(m_problems);
    return examined;
  }

 private:
  void report(const Problem& problem, const Place& where) { m_problems.push_back({problem.what, where}); }

  template <typename Value>
  std::optional<Value> take(const Result<Value>& result, const Place& where) {
    if (result) return *result;
    report(result.problem(), where);
    return std::nullopt;
  }

  /// The entry's value; empty, and reported, where it cannot be used. The inner optional is an entry left
  /// empty.
  std::optional<std::optional<double>> number(const std::string& field, const std::string& text) {
    return take(numberEntry(field, text), {.field = field});
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
    m_measurement.sigmaZeroHorizontal = stated ? sigmaZero : m_measurement.sigmaHorizontal;
    m_measurement.sigmaZeroVertical = stated ? sigmaZero : m_measurement.sigmaVertical;
    m_measurement.sigmaSlider = sigma("instrument.sigma_slider_arcsec", instrument.sigmaSliderArcsec);
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
  }

  void examineAcceptance() {
    const Acceptance& acceptance = m_session.acceptance;
    const auto tolerance = number("acceptance.tolerance_mm", acceptance.toleranceMm);
    const auto coverage = number("acceptance.coverage", acceptance.coverage);
    const auto reference = number("acceptance.reference_intersection_mm", acceptance.referenceIntersectionMm);
    m_measurement.tolerance = coverage ? tolerance.value_or(std::nullopt) : std::nullopt;
    if (coverage) m_measurement.coverage = coverage->value_or(m_measurement.coverage);
    m_measurement.referenceIntersection = reference.value_or(std::nullopt);
  }

  void examinePositions() {
    std::map<int, std::size_t> positionOfAxis;
    for (std::size_t index = 0; index < m_session.positions.size(); ++index) {
      const Position& position = m_session.positions[index];
      const Place axisPlace{.position = index, .field = "axis_deg"};
      auto axis = take(axisEntry(position.axisDeg), axisPlace);
      if (axis) {
        const auto [known, isNew] = positionOfAxis.emplace(*axis, index);
        if (!isNew) {
          report({std::to_string(*axis) + "° is already the axis of position " +
                  std::to_string(known->second + 1) + ": change one of the two or join their readings"},
                 axisPlace);
          axis.reset();
        }
      }
      const auto zero = examineZero(position.zero, index);
      std::vector<Sighting> sightings = examineReadings(position, index, zero);
      if (axis && zero && m_circle)
        m_measurement.arcs.push_back({index, *axis, zero->horizontal, zero->vertical, std::move(sightings)});
      m_measurement.rows += position.readings.size();
    }
    std::ranges::sort(m_measurement.arcs, {}, &ArcMeasurement::axisDeg);
  }

  /// Where the kind of circle is unknown, the wider range of the elevation circle holds.
  VerticalCircle circleForRanges() const { return m_circle.value_or(VerticalCircle::Elevation); }

  std::optional<Angle> angle(const char* field, const std::string& text, const Place& where) {
    return take(angleEntry(field, text, circleForRanges()), where).value_or(std::nullopt);
  }

  std::optional<ZeroDirection> examineZero(const PointingZero& zero, std::size_t position) {
    const auto horizontal = angle("pointing_zero.horizontal", zero.horizontal,
                                  {.position = position, .field = "pointing_zero.horizontal"});
    const auto vertical = angle("pointing_zero.vertical", zero.vertical,
                                {.position = position, .field = "pointing_zero.vertical"});
    if (!horizontal || !vertical) return std::nullopt;
    return ZeroDirection{*horizontal, *vertical};
  }

  std::vector<Sighting> examineReadings(const Position& position, std::size_t index,
                                        const std::optional<ZeroDirection>& zero) {
    std::vector<Sighting> sightings;
    m_rowOfVisitFace.clear();
    m_rowOfVisitFace.reserve(position.readings.size());
    sightings.reserve(position.readings.size());
    for (std::size_t row = 0; row < position.readings.size(); ++row) {
      const Reading& reading = position.readings[row];
      if (reading.excluded) continue;
      if (auto sighting = examineReading(reading, {.position = index, .reading = row}, zero)) {
        sightings.push_back(*sighting);
      }
    }
    return sightings;
  }

  static Place at(Place row, const char* field) {
    row.field = field;
    return row;
  }

  /// The row reduced from `zero`; empty where it cannot be used or there is nothing to reduce it from.
  std::optional<Sighting> examineReading(const Reading& reading, const Place& row,
                                         const std::optional<ZeroDirection>& zero) {
    if (isUntouched(reading)) {
      report({"is empty, as is the whole row: type its readings or delete the row"}, at(row, "horizontal"));
      return std::nullopt;
    }
    const std::size_t before = m_problems.size();
    Sighting sighting;
    sighting.row = *row.reading;
    sighting.sequence = m_firstSequences[*row.position] + sighting.row;
    examineVisit(reading, row, sighting);
    const auto horizontal = angle("readings.horizontal", reading.horizontal, at(row, "horizontal"));
    const auto vertical = angle("readings.vertical", reading.vertical, at(row, "vertical"));
    const std::size_t beforeReduction = m_problems.size();
    if (horizontal && vertical && zero && m_circle && beforeReduction == before) {
      reduce(inFaceOne(*horizontal, *vertical, sighting.face, *m_circle), *zero, sighting);
      checkWidth(sighting.a, reading.horizontal, at(row, "horizontal"));
      checkWidth(sighting.e, reading.vertical, at(row, "vertical"));
    }
    sighting.slider = angle("readings.slider", reading.slider, at(row, "slider"));
    if (m_problems.size() > before || !zero) return std::nullopt;
    return sighting;
  }

  /// Point, round and face; the same three twice in one position are a slip of the pen.
  void examineVisit(const Reading& reading, const Place& row, Sighting& sighting) {
    const auto point = take(wholeEntry("readings.point", reading.point), at(row, "point"));
    const auto round = take(wholeEntry("readings.round", reading.round), at(row, "round"));
    const auto face = take(wholeEntry("readings.face", reading.face), at(row, "face"));
    if (!point || !round || !face) return;
    sighting.point = point->value_or(static_cast<int>(*row.reading) + 1);
    sighting.round = **round;
    sighting.face = **face;
    const auto [first, isNew] =
        m_rowOfVisitFace.emplace(VisitFace{sighting.round, sighting.point, sighting.face}, *row.reading);
    if (isNew) return;
    report({"point " + std::to_string(sighting.point) + ", round " + std::to_string(sighting.round) +
            ", face " + std::to_string(sighting.face) + " is already in row " +
            std::to_string(first->second + 1) + ": give it another point or round, or exclude one"},
           at(row, "point"));
  }

  void reduce(const FaceOneReading& reading, const ZeroDirection& zero, Sighting& sighting) const {
    sighting.a = wrapped(reading.horizontal - zero.horizontal);
    const bool zenith = *m_circle == VerticalCircle::Zenith;
    sighting.e = wrapped(zenith ? zero.vertical - reading.vertical : reading.vertical - zero.vertical);
  }

  void checkWidth(Angle reduced, const std::string& text, const Place& where) {
    const double degrees = std::abs(reduced.degrees());
    if (degrees < widestDegrees) return;
    report({quotation(text) + " lies " + fixedText(degrees, 0) +
            "° from the pointing zero, beyond the edge of the arc plane: check the degrees and the face"},
           where);
  }

  const Session& m_session;
  const std::vector<std::size_t> m_firstSequences;  // of each position
  Measurement m_measurement;
  std::vector<Problem> m_problems;
  bool m_usable = true;
  std::optional<VerticalCircle> m_circle;
  std::unordered_map<VisitFace, std::size_t, HashOfVisitFace> m_rowOfVisitFace;
};

}  // namespace

Examined examine(const Session& session) {
  return Examiner(session).examine();
}

}  // namespace alidade
