#pragma once

#include <cstddef>

namespace alidade {

/// The largest number of amplitudes that the user's own effects may have together in one session.
inline constexpr std::size_t mostOwnTerms = 6;

/// The errors of instrument and guideway: parameters of the forward model, zero without errors. Angles are in
/// radians, lengths in mm. `s` is the slider coordinate, α and β are circle readings of face 1.
enum class ErrorTerm : std::size_t {
  VerticalAngleRelation,  ///< 0: the session's own relation between y and e; 1: the other relation (exact ↔
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
  VerticalDrift,             ///< as `HorizontalDrift`, vertical: zenith readings grow with positive drift
  HorizontalJump,            ///< change of the orientation at the jump
  VerticalJump,
  SetupShiftX,        ///< shift of the target relative to the instrument, +x, in positions after the first
  SetupShiftY,        ///< shift of the target relative to the instrument, +y, in positions after the first
  PlaneTiltX,         ///< rotation of the arc plane about +x through the arc centre
  PlaneTiltY,         ///< rotation of the arc plane about +y through the arc centre
  PlaneOffset,        ///< the arc plane's distance from the rotation axis: nearer at 0°, farther at 180°
  PlaneSkew,          ///< tilt ε of the arc plane, fixed to the guideway: target off the plane by ε R cos s
  AxialShift,         ///< shift of the guideway along its axis, +x, from position 0° to 180°
  RadiusChange,       ///< change of the radius from position 0° to 180°
  EllipticityCosine,  ///< radius + A cos 2s + B sin 2s: A
  EllipticitySine,    ///< B
  LobingCosine,       ///< radius + A cos 3s + B sin 3s: A
  LobingSine,         ///< B
  GravitySag,         ///< lowers the target by g sin s in either position of the guideway
  ArmSag,             ///< moves the target along the arc by −g cos φ: downwards in either position
  WarpCosine,         ///< target off the plane by A cos 2s + B sin 2s, turning with the guideway: A
  WarpSine,           ///< B
  SliderScale,        ///< slider reading = s (1 + k) + …
  SliderSine,         ///< … + A sin s
  OwnGuideway,  ///< the first of `mostOwnTerms` amplitudes of the user's own effects that move the target or
                ///< the slider reading
  OwnInstrument = OwnGuideway + mostOwnTerms,  ///< the first of `mostOwnTerms` amplitudes on the circles
  Count = OwnInstrument + mostOwnTerms,
};

inline constexpr std::size_t errorTermCount = static_cast<std::size_t>(ErrorTerm::Count);

/// The first term of the guideway.
inline constexpr auto firstGuidewayTerm = static_cast<std::size_t>(ErrorTerm::PlaneTiltX);
/// The first term of the user's own effects. No effect of the catalogue has this or a later term.
inline constexpr auto firstOwnTerm = static_cast<std::size_t>(ErrorTerm::OwnGuideway);
inline constexpr auto firstOwnInstrumentTerm = static_cast<std::size_t>(ErrorTerm::OwnInstrument);

/// Does the term belong to the guideway? Otherwise it belongs to the instrument.
constexpr bool isOfGuideway(ErrorTerm term) {
  return static_cast<std::size_t>(term) >= firstGuidewayTerm &&
         static_cast<std::size_t>(term) < firstOwnInstrumentTerm;
}

/// Is the term an amplitude of an effect of the user's own?
constexpr bool isOwn(ErrorTerm term) {
  return static_cast<std::size_t>(term) >= firstOwnTerm;
}

/// Is the term part of a jump? A jump has a moment of its own and is outside the catalogue.
constexpr bool isOfJump(ErrorTerm term) {
  return term == ErrorTerm::HorizontalJump || term == ErrorTerm::VerticalJump;
}

}  // namespace alidade
