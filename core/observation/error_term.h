#pragma once

#include <array>
#include <cstddef>

namespace alidade {

/// The errors of instrument and guideway: parameters of the forward model that are zero for perfect ones.
/// Angles in radians, lengths in mm. `s` is the slider coordinate, α and β are circle readings of face 1.
enum class ErrorTerm : std::size_t {
  VerticalAngleRelation,  ///< 0: the session's own relation between y and e; 1: the other one (exact ↔
                          ///< planar)
  Collimation,        ///< c: line of sight against the perpendicular of the trunnion axis; δα = ±c/cos e
  TrunnionTilt,       ///< i: trunnion axis against the perpendicular of the vertical axis; δα = ±i tan e
  VerticalIndex,      ///< j: added to the vertical circle's reading in both faces
  VerticalAxisTiltX,  ///< the vertical axis is tilted towards the observer (turned about +x)
  VerticalAxisTiltZ,  ///< the vertical axis is tilted to the left (turned about +z)
  HorizontalCircleSine,      ///< δα = A sin α + B cos α of the circle reading of either face: A
  HorizontalCircleCosine,    ///< B
  VerticalCircleSine,        ///< δβ = A sin β + B cos β of the circle reading of either face: A
  VerticalCircleCosine,      ///< B
  VerticalGraduationSine,    ///< δβ = A sin 2β + B cos 2β of the circle reading of either face: A
  VerticalGraduationCosine,  ///< B
  VerticalRefraction,        ///< k: e is read too large by k (e/10°)²
  HorizontalDrift,           ///< rotation of the orientation from the first reading of the session to the
                             ///< last
  VerticalDrift,             ///< the same for the vertical circle; zenith readings grow with positive drift
  HorizontalJump,            ///< step of the orientation at the moment of the jump
  VerticalJump,
  SetupShiftX,        ///< of the target relative to the instrument, +x, in every position after the first
  SetupShiftY,        ///< +y
  PlaneTiltX,         ///< the arc plane turned about +x through the arc centre
  PlaneTiltY,         ///< about +y
  PlaneOffset,        ///< the arc plane's distance from the rotation axis: nearer at 0°, farther at 180°
  PlaneSkew,          ///< skew of the arc plane to its own axis: off it by ε R cos s, turning with the
                      ///< guideway
  AxialShift,         ///< of the guideway along its axis, +x, from position 0° to 180°
  RadiusChange,       ///< of the radius from position 0° to 180°
  EllipticityCosine,  ///< radius + A cos 2s + B sin 2s: A
  EllipticitySine,    ///< B
  LobingCosine,       ///< radius + A cos 3s + B sin 3s: A
  LobingSine,         ///< B
  GravitySag,         ///< y − g sin s, downwards in either position of the guideway
  ArmSag,       ///< along the arc by −g cos φ, which lowers the target in either position of the guideway
  WarpCosine,   ///< target off the plane by A cos 2s + B sin 2s, turning with the guideway: A
  WarpSine,     ///< B
  SliderScale,  ///< slider reading = s (1 + k) + …
  SliderSine,   ///< … + A sin s
  Count,
};

inline constexpr std::size_t errorTermCount = static_cast<std::size_t>(ErrorTerm::Count);

/// The first term of the guideway; all later ones belong to it too.
inline constexpr auto firstGuidewayTerm = static_cast<std::size_t>(ErrorTerm::PlaneTiltX);

/// Does the term belong to the guideway? Otherwise it belongs to the instrument.
constexpr bool isOfGuideway(ErrorTerm term) {
  return static_cast<std::size_t>(term) >= firstGuidewayTerm;
}

/// Is it a step of the orientation? That has a moment of its own and is outside the catalogue.
constexpr bool isOfJump(ErrorTerm term) {
  return term == ErrorTerm::HorizontalJump || term == ErrorTerm::VerticalJump;
}

/// The sizes of all error terms; zero unless set.
template <typename T>
class ErrorTerms {
 public:
  /// `zero` if T() is not a valid zero, as for a jet of dynamic size.
  ErrorTerms() : ErrorTerms(T(0)) {}
  explicit ErrorTerms(const T& zero) { m_sizes.fill(zero); }

  void set(ErrorTerm term, const T& size) {
    m_sizes[static_cast<std::size_t>(term)] = size;
    m_isPerfect = false;
  }
  const T& operator[](ErrorTerm term) const { return m_sizes[static_cast<std::size_t>(term)]; }

  /// No term was set, so the short formulas of the perfect model apply.
  bool isPerfect() const { return m_isPerfect; }

 private:
  std::array<T, errorTermCount> m_sizes;
  bool m_isPerfect = true;
};

}  // namespace alidade
