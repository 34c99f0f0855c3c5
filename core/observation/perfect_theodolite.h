#pragma once

#include <cmath>
#include <numbers>

#include "core/session/measurement.h"

namespace alidade {

// The situation: a theodolite without errors at the origin of o0 (x right, y up, z towards the observer)
// sights a target in the arc plane z = −L. Relative to the direction perpendicular to the plane, it reads
//
//   a = atan2(x, L) right positive
//   e = atan2(y, √(x² + L²)) up positive
//
// The published method uses tan e = y/L instead (`Planar`). Both maps are one-to-one between the plane and
// the open quadrants |a|, |e| < 90°. The scalar type is a template parameter: derivatives come from automatic
// differentiation. Source of the exact relation: the geometry of a theodolite with perpendicular axes. Source
// of the planar relation: equation (3) of Cui, Ren, Yuan, Liu, "Intersection Measurement for Rotatable Arc
// Guideway System".

/// Reduced readings in radians.
template <typename T>
struct Direction {
  T a, e;
};

/// A point of the arc plane in mm, in o0.
template <typename T>
struct PlanePoint {
  T x, y;
};

/// The reading of the vertical circle at elevation `e`, rad, in `face`.
inline double verticalCircleReading(double e, int face, VerticalCircle circle) {
  const bool isZenith = circle == VerticalCircle::Zenith;
  const double inFaceOne = isZenith ? std::numbers::pi / 2 - e : e;
  return face == 1 ? inFaceOne : (isZenith ? 2 : 1) * std::numbers::pi - inFaceOne;
}

/// The reading for a target at `target`; `distance` is L > 0 in mm. Always finite.
template <typename T>
Direction<T> observe(const PlanePoint<T>& target, const T& distance, VerticalAngleRelation relation) {
  using std::atan2, std::sqrt;
  const T horizontalDistance = relation == VerticalAngleRelation::Exact
                                   ? T(sqrt(target.x * target.x + distance * distance))
                                   : distance;
  return {atan2(target.x, distance), atan2(target.y, horizontalDistance)};
}

/// The intersection of the line of sight with the arc plane: the inverse of `observe`. Needs |a|, |e| < 90°.
inline PlanePoint<double> sightedPoint(const Direction<double>& direction, double distance,
                                       VerticalAngleRelation relation) {
  const double x = distance * std::tan(direction.a);
  const double horizontalDistance =
      relation == VerticalAngleRelation::Exact ? std::hypot(x, distance) : distance;
  return {x, horizontalDistance * std::tan(direction.e)};
}

}  // namespace alidade
