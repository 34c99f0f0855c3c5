#include "core/adjustment/result/expected_reading.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/observation/guideway.h"
#include "core/observation/half_turn.h"
#include "core/observation/zero_line.h"
#include "core/session/face.h"

namespace alidade {

namespace {

// Largest deviations within a visit, and of a point between visits. They allow for a collimation or index
// error of some minutes and for a mark missed by some millimetres: the marks of the published table differ by
// 1.3 mm between positions, at a radius of 400 mm.
constexpr Angle sameVisit = Angle::fromArcseconds(360);
constexpr Angle samePoint = Angle::fromArcseconds(900);
constexpr double centreShare =
    0.02;  // of the radius: possible offset of the centre from the middle of the field
constexpr double scaleOff = 0.5, scaleUnknown = 3;  // degrees: possible error of a slider's scale
constexpr double stepShare = 0.5;  // of the step from point to point: possible error of an interpolated place

/// The slider's coordinate s at each point.
using Places = std::map<int, MeanDirection>;

/// s = first + step · point.
struct Line {
  double first = 0, step = 0;
};

/// The line through places that are evenly spaced by point number. A place is at most half a turn from the
/// one before.
std::optional<Line> lineThrough(const Places& places) {
  constexpr std::size_t fewest = 3;
  constexpr double evenly = 0.2;  // of a step
  if (places.size() < fewest) return {};
  const auto count = static_cast<double>(places.size());
  std::map<int, double> coordinates;
  Angle last = places.begin()->second.value();
  double meanPoint = 0, meanS = 0;
  for (const auto& [point, place] : places) {
    last = wrapped(place.value(), last);
    coordinates[point] = last.radians();
    meanPoint += point / count;
    meanS += last.radians() / count;
  }
  double products = 0, squares = 0;
  for (const auto& [point, s] : coordinates) {
    products += (point - meanPoint) * (s - meanS);
    squares += (point - meanPoint) * (point - meanPoint);
  }
  const Line line{meanS - products / squares * meanPoint, products / squares};
  const bool isEven = std::ranges::all_of(coordinates, [&](const auto& known) {
    return std::abs(known.second - line.first - line.step * known.first) < evenly * std::abs(line.step);
  });
  return isEven ? std::optional(line) : std::nullopt;
}

bool isNear(const Places& places, int point) {
  const double first = places.begin()->first, last = places.rbegin()->first;
  return point >= first - (last - first) / 2 && point <= last + (last - first) / 2;
}

/// The coordinate from which a place is predicted.
struct Coordinate {
  double s = 0;
  Angle tolerance;
};

class Expectations {
 public:
  Expectations(const Measurement& measurement, const SessionFit& fit, const NominalPlaces& nominal)
      : m_measurement(measurement), m_fit(fit), m_nominal(nominal) {
    for (const ArcMeasurement& arc : measurement.arcs)
      for (const Sighting& sighting : arc.sightings) {
        const double s = coordinateOf(arc, sighting);
        m_places[sighting.point].add(Angle::fromRadians(s));
        const auto planned = nominal.find({arc.position, sighting.point});
        if (planned == nominal.end()) continue;
        m_offsets[keyOf(planned->second)].add(Angle::fromRadians(s - planned->second));
        m_offset.add(Angle::fromRadians(s - planned->second));
      }
    m_line = lineThrough(m_places);
  }

  std::optional<ExpectedReading> of(const SightingToCome& sighting) const {
    const auto arc = std::ranges::find(m_measurement.arcs, sighting.position, &ArcMeasurement::position);
    if (arc == m_measurement.arcs.end()) return {};
    const auto place = placeOf(*arc, sighting);
    return place ? std::optional(reading(*arc, sighting, *place)) : std::nullopt;
  }

 private:
  /// The fitted circle, of this or another position, else the nominal one.
  Circle circleOf(const ArcMeasurement& arc) const {
    if (const ArcFit* own = m_fit.arcOfPosition(arc.position)) return own->circle;
    if (!m_fit.arcs.empty()) return m_fit.arcs.front().circle;
    return {0, 0, m_measurement.nominalRadius};
  }

  double coordinateOf(const ArcMeasurement& arc, const Sighting& sighting) const {
    const PlanePoint<double> point = ZeroLine(m_measurement, arc).sightedPoint(sighting);
    return sliderCoordinateOf(nearestArcAngle(circleOf(arc), point), arc.axisDeg);
  }

  std::optional<Coordinate> placeOf(const ArcMeasurement& arc, const SightingToCome& wanted) const {
    for (const Sighting& sighting : arc.sightings)
      if (sighting.point == wanted.point && sighting.round == wanted.round)
        return Coordinate{coordinateOf(arc, sighting), sameVisit};
    if (const auto planned = m_nominal.find({arc.position, wanted.point}); planned != m_nominal.end())
      return nominalPlace(planned->second);
    if (const auto known = m_places.find(wanted.point); known != m_places.end())
      return Coordinate{known->second.value().radians(), samePoint};
    if (!m_line || !isNear(m_places, wanted.point)) return {};
    const double atTheodolite = std::abs(m_line->step) * m_measurement.nominalRadius / m_measurement.distance;
    return Coordinate{m_line->first + m_line->step * wanted.point,
                      samePoint + Angle::fromRadians(stepShare * atTheodolite)};
  }

  /// Coordinates that are equal to the arcsecond belong to one place.
  static long long keyOf(double s) { return std::llround(Angle::fromRadians(s).arcseconds()); }

  Coordinate nominalPlace(double s) const {
    if (const auto known = m_offsets.find(keyOf(s)); known != m_offsets.end())
      return {s + known->second.value().radians(), samePoint};
    const double off = m_offsets.empty() ? scaleUnknown : scaleOff;
    const double atTheodolite =
        off * std::numbers::pi / 180 * m_measurement.nominalRadius / m_measurement.distance;
    return {m_offsets.empty() ? s : s + m_offset.value().radians(),
            samePoint + Angle::fromRadians(atTheodolite)};
  }

  ExpectedReading reading(const ArcMeasurement& arc, const SightingToCome& sighting,
                          const Coordinate& place) const {
    const Circle circle = circleOf(arc);
    const PlanePoint<double> target =
        targetOnArc(circle.x, circle.y, circle.radius, arcAngleOf(place.s, arc.axisDeg));
    const Direction<double> direction = ZeroLine(m_measurement, arc).observe(target);
    const bool isZenith = m_measurement.verticalCircle == VerticalCircle::Zenith;
    const Angle e = Angle::fromRadians(direction.e);
    const FaceOneReading circles =  // the conversion to face 1 is its own inverse, up to whole turns
        inFaceOne(arc.zeroHorizontal + Angle::fromRadians(direction.a),
                  isZenith ? arc.zeroVertical - e : arc.zeroVertical + e, sighting.face,
                  m_measurement.verticalCircle);
    const bool isFitted = m_fit.arcOfPosition(arc.position) != nullptr;
    const Angle ofCentre =
        Angle::fromRadians(isFitted ? 0 : centreShare * m_measurement.nominalRadius / m_measurement.distance);
    return {sighting, wrapped(circles.horizontal, Angle::fromDegrees(180)),
            wrapped(circles.vertical, Angle::fromDegrees(isZenith ? 180 : 90)),
            std::min(place.tolerance + ofCentre, Angle::fromDegrees(180))};
  }

  const Measurement& m_measurement;
  const SessionFit& m_fit;
  const NominalPlaces& m_nominal;
  Places m_places;
  std::map<long long, MeanDirection> m_offsets;  ///< mean offset from each nominal coordinate
  MeanDirection m_offset;                        ///< mean over all coordinates
  std::optional<Line> m_line;
};

}  // namespace

std::vector<std::optional<ExpectedReading>> expectedReadings(const Measurement& measurement,
                                                             const SessionFit& fit,
                                                             const std::vector<SightingToCome>& sightings,
                                                             const NominalPlaces& nominal) {
  const Expectations expectations(measurement, fit, nominal);
  std::vector<std::optional<ExpectedReading>> expected;
  for (const SightingToCome& sighting : sightings) expected.push_back(expectations.of(sighting));
  return expected;
}

}  // namespace alidade
