#pragma once

#include "core/base/angle.h"

namespace alidade {

// The guideway's two positions differ by half a turn about the x direction. Coordinates fixed to the guideway
// keep their x and change the sign of y, z and angles in the arc plane at 180°. The slider coordinate s is
// such an angle: it is fixed to the guideway, as the arc angle φ is to o0.

/// Sign of y, z and arc angles between guideway and o0, in both directions: 1 at axis 0°, −1 at 180°.
constexpr double halfTurnSign(int axisDeg) {
  return axisDeg == 0 ? 1 : -1;
}

/// The slider coordinate s at arc angle `phi`, in the unit of `phi`: φ at axis 0°, −φ at 180°.
template <typename T>
constexpr T sliderCoordinateOf(const T& phi, int axisDeg) {
  return axisDeg == 0 ? phi : T(-phi);
}

/// The arc angle φ at slider coordinate `s`, by the same formula: half a turn is its own inverse.
template <typename T>
constexpr T arcAngleOf(const T& s, int axisDeg) {
  return sliderCoordinateOf(s, axisDeg);
}

/// s in [−90°, 270°) at `phi`, rad. The seam lies opposite the middle of the guideway, so that places to both
/// sides of s = 180° are neighbours.
inline Angle unwrappedSliderCoordinate(double phi, int axisDeg) {
  return wrapped(Angle::fromRadians(sliderCoordinateOf(phi, axisDeg)), Angle::fromDegrees(90));
}

/// Changes φ, rad, by whole turns so that s lies in [−90°, 270°).
inline double unwrappedArcAngle(double phi, int axisDeg) {
  return arcAngleOf(unwrappedSliderCoordinate(phi, axisDeg).radians(), axisDeg);
}

/// ∂Δd/∂Δy of a position, from Δd = (Δy(0°) − Δy(180°))/2: 1/2 at axis 0°, −1/2 at 180°.
constexpr double intersectionPerHeight(int axisDeg) {
  return halfTurnSign(axisDeg) / 2;
}

}  // namespace alidade
