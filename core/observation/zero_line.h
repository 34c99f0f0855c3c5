#pragma once

#include "core/observation/guideway.h"
#include "core/observation/perfect_theodolite.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: the vertical circle counts from the plumb line, while reduced readings and the arc's centre
// count from the pointing zero. The zero is inclined by its elevation e0 unless the instrument is at the
// height of the axis. L is the distance of the arc plane along the zero's azimuth (vertical plane) or along
// the zero itself (square plane). A point (x, y, z) relative to the zero line is in space at
//
//   vertical (x, y + L tan e0, z)
//   square (x, y cos e0 − z sin e0, y sin e0 + z cos e0)
//
// and is sighted at the elevation e0 + e, where e is reduced. At e0 = 0 both formulas give the point itself.
// Using the reduced e as the elevation causes an error of e0 x²/(2 L²) in e, to first order. Source: rotation
// about the trunnion axis.

/// A point or vector, mm in o0.
template <typename T>
struct SpacePoint {
  T x, y, z;
};

/// Converts to space, x right, y plumb; `distance` L, `elevation` e0 in radians.
template <typename T>
SpacePoint<T> roomFromZeroLine(const SpacePoint<T>& point, const T& distance, double elevation,
                               ArcPlane plane) {
  const double sine = std::sin(elevation), cosine = std::cos(elevation);
  if (plane == ArcPlane::Vertical) return {point.x, point.y + distance * (sine / cosine), point.z};
  return {point.x, point.y * cosine - point.z * sine, point.y * sine + point.z * cosine};
}

/// Converts between reduced readings and places in the arc plane of one position, relative to its pointing
/// zero.
class ZeroLine {
 public:
  ZeroLine(const Measurement& measurement, const ArcMeasurement& arc)
      : m_distance(measurement.distance),
        m_elevation(arc.zeroElevation.radians()),
        m_plane(measurement.plane),
        m_relation(measurement.relation) {}

  /// e0, rad.
  double elevation() const { return m_elevation; }
  /// The intersection of the line of sight of a reduced reading with the arc plane, mm relative to the zero
  /// line.
  PlanePoint<double> sightedPoint(const Direction<double>& reduced) const;
  PlanePoint<double> sightedPoint(const Sighting& sighting) const {
    return sightedPoint(Direction<double>{sighting.a.radians(), sighting.e.radians()});
  }
  /// The reduced reading of a perfect theodolite to a point of the arc plane.
  Direction<double> observe(const PlanePoint<double>& point) const;
  /// The same for a point in space, mm relative to the zero line; z = −L in the arc plane.
  Direction<double> observeInSpace(const SpacePoint<double>& point) const;

  /// Converts a reduced reading for the kernels of a single arc, which assume a vertical plane and a level
  /// zero: the result counts from the horizon. Exact for a vertical plane. A reading of a square plane is
  /// rotated with the zero, so the weights of the two circles are exact only at the centre.
  Direction<double> levelled(const Direction<double>& reduced) const;
  /// y from the horizon, as the kernels count it, minus y relative to the zero line, mm.
  double height() const;
  /// Are the kernels of a single arc exact, with `levelled` readings, for this plane and elevation?
  bool isLevelExact() const { return m_plane == ArcPlane::Vertical || m_elevation == 0; }

 private:
  double m_distance, m_elevation;
  ArcPlane m_plane;
  VerticalAngleRelation m_relation;

  /// The line of sight of a reading whose e counts from the horizon, scaled to z = −1 along the azimuth of
  /// the zero.
  SpacePoint<double> lineOfSight(const Direction<double>& fromHorizon) const;
};

/// Gives a sighting the error-free reading of the point of a circle at the arc angle `phi`, rad. `line` is
/// that of its position; the slider reading is kept.
void sightPerfectly(Sighting& sighting, const ZeroLine& line, const Circle& circle, double phi);

}  // namespace alidade
