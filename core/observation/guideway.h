#pragma once

#include <cmath>

#include "core/observation/perfect_theodolite.h"

namespace alidade {

/// The circle traced by the slider's crosshair, in the arc plane, mm in o0.
struct Circle {
  double x = 0, y = 0;  ///< centre: Δx, Δy
  double radius = 0;

  bool operator==(const Circle&) const = default;
};

/// P(φ) = (x + R cos φ, y + R sin φ); φ in radians from +x, counter-clockwise as the observer sees it.
template <typename T>
PlanePoint<T> targetOnArc(const T& x, const T& y, const T& radius, const T& phi) {
  using std::cos, std::sin;
  return {x + radius * cos(phi), y + radius * sin(phi)};
}

/// The arc angle of the point of the circle nearest to `point`, in radians, in (−π, π].
inline double nearestArcAngle(const Circle& circle, const PlanePoint<double>& point) {
  return std::atan2(point.y - circle.y, point.x - circle.x);
}

}  // namespace alidade
