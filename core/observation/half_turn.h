#pragma once

namespace alidade {

// The guideway's two positions are half a turn about the x direction apart, so that what belongs to the
// guideway keeps its x and has y, z and its angles in the arc plane with the other sign at 180°. The slider
// coordinate s is such an angle: it belongs to the guideway, as the arc angle φ belongs to o0.

/// Of y, z and arc angles between guideway and o0, either way: 1 at axis 0°, −1 at 180°.
constexpr double halfTurnSign(int axisDeg) {
  return axisDeg == 0 ? 1 : -1;
}

/// s where the slider stands at arc angle `phi`, in its unit: φ at axis 0°, −φ at 180°.
template <typename T>
constexpr T sliderCoordinateOf(const T& phi, int axisDeg) {
  return axisDeg == 0 ? phi : T(-phi);
}

/// φ of slider coordinate `s`: half a turn is its own inverse.
template <typename T>
constexpr T arcAngleOf(const T& s, int axisDeg) {
  return sliderCoordinateOf(s, axisDeg);
}

/// ∂Δd/∂Δy of the position: Δd = (Δy(0°) − Δy(180°))/2, so a centre counts as the guideway's own y has it.
constexpr double intersectionPerHeight(int axisDeg) {
  return halfTurnSign(axisDeg) / 2;
}

}  // namespace alidade
