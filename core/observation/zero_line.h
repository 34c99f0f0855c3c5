#pragma once

#include "core/observation/perfect_theodolite.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: the vertical circle counts from the plumb line, while reduced readings and the arc's centre
// count from the pointing zero, which is inclined by its elevation e0 wherever the instrument does not stand
// at the height of the axis. With L the distance of the arc plane along the zero's azimuth (a vertical plane)
// or along the zero itself (a square one), a point (x, y, z) over the zero line stands in the room at
//
//   vertical  (x, y + L tan e0, z)
//   square    (x, y cos e0 − z sin e0, y sin e0 + z cos e0)
//
// and is sighted at the elevation e0 + e, e being reduced. At e0 = 0 both are the point itself. An elevation
// taken for e instead errs by e0 x²/(2 L²) to first order. Source: rotation about the trunnion axis.

/// A point or vector, mm in o0.
template <typename T>
struct SpacePoint {
  T x, y, z;
};

/// In the room, x right, y plumb; `distance` L, `elevation` e0 in radians.
template <typename T>
SpacePoint<T> roomFromZeroLine(const SpacePoint<T>& point, const T& distance, double elevation,
                               ArcPlane plane) {
  const double sine = std::sin(elevation), cosine = std::cos(elevation);
  if (plane == ArcPlane::Vertical) return {point.x, point.y + distance * (sine / cosine), point.z};
  return {point.x, point.y * cosine - point.z * sine, point.y * sine + point.z * cosine};
}

/// Of one position: between reduced readings and places in the arc plane over its pointing zero.
class ZeroLine {
 public:
  ZeroLine(const Measurement& measurement, const ArcMeasurement& arc)
      : m_distance(measurement.distance),
        m_elevation(arc.zeroElevation.radians()),
        m_plane(measurement.plane),
        m_relation(measurement.relation) {}

  /// e0, rad.
  double elevation() const { return m_elevation; }
  /// Where the line of sight of a reduced reading meets the arc plane, mm over the zero line.
  PlanePoint<double> sightedPoint(const Direction<double>& reduced) const;
  PlanePoint<double> sightedPoint(const Sighting& sighting) const {
    return sightedPoint(Direction<double>{sighting.a.radians(), sighting.e.radians()});
  }
  /// The reduced reading of a perfect theodolite to a point of the arc plane.
  Direction<double> observe(const PlanePoint<double>& point) const;

  /// The kernels of a single arc stand in front of a vertical plane with a level zero. The reading as they
  /// take it, from the horizon: exact of a vertical plane; of a square one turned with the zero, which
  /// weighs the two circles exactly at the centre alone.
  Direction<double> levelled(const Direction<double>& reduced) const;
  /// By what y of the kernels is more than y over the zero line, mm.
  double height() const;
  /// The kernels are exact.
  bool isLevelExact() const { return m_plane == ArcPlane::Vertical || m_elevation == 0; }

 private:
  double m_distance, m_elevation;
  ArcPlane m_plane;
  VerticalAngleRelation m_relation;

  /// Of a reading from the horizon, forward 1 along the azimuth of the zero.
  SpacePoint<double> lineOfSight(const Direction<double>& fromHorizon) const;
};

}  // namespace alidade
