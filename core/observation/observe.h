#pragma once

#include <cmath>
#include <numbers>

#include "core/observation/error_term.h"
#include "core/observation/guideway.h"
#include "core/observation/half_turn.h"
#include "core/observation/own_model.h"
#include "core/observation/perfect_theodolite.h"
#include "core/observation/zero_line.h"
#include "core/session/measurement.h"

namespace alidade {

// The one forward model: a theodolite with errors sights the slider, at s, of a guideway with errors. The
// model is exact: the theodolite is rotated until it sights the target, and rotations are not linearised.
//
// The situation in o0 (origin at the theodolite's centre, x right, y up, z towards the observer): the arc of
// position p has centre (x, y, −L) and radius R; the slider is at φ, counter-clockwise from +x; s = φ at axis
// 0°, s = −φ at 180°, where the guideway is rotated by half a turn about the x direction.
//
// The theodolite: its vertical axis is tilted by the two axis tilts; the alidade turns about it to α; the
// trunnion axis is tilted by i against the perpendicular; the telescope turns about this axis to e; the line
// of sight deviates by c. A target in the direction (r, u, f) (right, up, forward) of the tilted instrument
// is sighted at
//
//   sin e = (u + sin c sin i)/(cos c cos i)
//   a = atan2(r, f) ± atan2(sin c cos i + cos c sin e sin i, cos c cos e)
//
// with + in face 1 and (r, u, f) of unit length. In face 1 the circles read α0 + a and 90° − e (e on an
// elevation circle); in face 2 they read α0 + a + 180° and 270° + e (180° − e). Each circle has its
// eccentricity. The pointing zero may be inclined against the horizon: zero_line.h. Source: the geometry of
// the instrument; to first order the formulas of any textbook (δα = ±c/cos e, ±i tan e).

/// The arc of one position and the orientation of its readings.
template <typename T>
struct ArcPose {
  T x, y, radius;    ///< mm
  T horizontalZero;  ///< error of α0 as read, rad: decreases readings
  T verticalZero;    ///< error of β0 as read, positive upwards: increases e
  T sliderZero;      ///< slider reading at s = 0, rad
};

/// The properties of one pointing, except the unknowns of the fit.
struct Pointing {
  int face = 1;
  double elapsed = 0;         ///< elapsed share of the session at the pointing, 0…1
  double jumpShare = 0;       ///< 0 before the jump, 1 after it; fractional for a mean of sightings
  bool isSetUpAgain = false;  ///< the slider, not a zero, is sighted in a position after the first
  double horizontalZero = 0;  ///< α0 as read, rad: the circle position that determines the eccentricity error
  VerticalCircle circle = VerticalCircle::Zenith;
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
  const OwnPlace* own = nullptr;  ///< where the user's own effects act; null: there are none
};

/// The displacement by the user's own effects at φ; `distance` in mm.
template <typename T>
OwnDisplacement<T> ownDisplacementAt(const ErrorTerms<T>& errors, const ArcPose<T>& arc, double distance,
                                     const T& phi, int axisDeg, const OwnPlace& own) {
  const PlanePoint<double> centre{plainValue(arc.x), plainValue(arc.y)};
  return ownDisplacement(
      own.model->ofGuideway(own, centre, plainValue(arc.radius), distance, plainValue(phi), axisDeg), errors,
      phi);
}

/// Adds the displacement by the user's own effects to the target, in the frames of the guideway and of the
/// room.
template <typename T>
void displace(SpacePoint<T>& target, const OwnDisplacement<T>& by, const T& phi, double turn) {
  using std::cos, std::sin;
  const T along = turn * by.tangential;
  target.x += by.radial * cos(phi) - along * sin(phi) + by.x;
  target.y += by.radial * sin(phi) + along * cos(phi) + by.y;
  target.z += turn * by.across + by.z;
}

/// The place of the target, mm in o0, for the slider at arc angle φ (rad). `own`: where the user's own
/// effects act, null without any.
template <typename T>
SpacePoint<T> targetAt(const ErrorTerms<T>& errors, const ArcPose<T>& arc, const T& distance, const T& phi,
                       int axisDeg, const OwnPlace* own = nullptr) {
  using std::cos, std::sin;
  using enum ErrorTerm;
  if (errors.isPerfect()) {
    const PlanePoint<T> target = targetOnArc(arc.x, arc.y, arc.radius, phi);
    return {target.x, target.y, -distance};
  }
  const double turn = halfTurnSign(axisDeg);
  const T s = sliderCoordinateOf(phi, axisDeg);
  const T cos2 = cos(2 * s), sin2 = sin(2 * s), cos3 = cos(3 * s), sin3 = sin(3 * s);
  const double turned = (1 - turn) / 2;
  const T radius = arc.radius + turned * errors[RadiusChange] + errors[EllipticityCosine] * cos2 +
                   errors[EllipticitySine] * sin2 + errors[LobingCosine] * cos3 + errors[LobingSine] * sin3;
  // x, y: the place in the guideway's plane; `off`: the offset from this plane, which turns with the
  // guideway. The tilts rotate x, y and `off` about the arc centre, and are the same in o0 in both positions.
  const T x = radius * cos(phi), y = radius * sin(phi);
  const T off =
      turn * (errors[WarpCosine] * cos2 + errors[WarpSine] * sin2 + errors[PlaneSkew] * arc.radius * cos(s));
  const T &tiltX = errors[PlaneTiltX], &tiltY = errors[PlaneTiltY];
  const T yTilted = y * cos(tiltX) - off * sin(tiltX), zTilted = y * sin(tiltX) + off * cos(tiltX);
  const T xTurned = x * cos(tiltY) + zTilted * sin(tiltY), zTurned = zTilted * cos(tiltY) - x * sin(tiltY);
  const T drop = errors[GravitySag] * sin(s) + errors[ArmSag] * cos(phi) * cos(phi);
  SpacePoint<T> target{arc.x + turned * errors[AxialShift] + xTurned + errors[ArmSag] * cos(phi) * sin(phi),
                       arc.y + yTilted - drop, zTurned + turn * errors[PlaneOffset] - distance};
  if (own)
    displace(target, ownDisplacementAt(errors, arc, plainValue(distance), phi, axisDeg, *own), phi, turn);
  return target;
}

/// Adds the user's own effects on the circles to the direction (a, e), rad, that is read without them.
template <typename T>
void addOwn(const ErrorTerms<T>& errors, const OwnPlace& own, T& a, T& e) {
  const T offA = a - plainValue(a), offE = e - plainValue(e);
  for (const OwnShare& share : own.model->ofCircles(own, plainValue(a), plainValue(e))) {
    const T factor = share.value + T(share.byA * offA) + T(share.byE * offE);
    const T added = errors[share.term] * factor;
    if (share.carrier != FormCarrier::Vertical) a += added;
    if (share.carrier != FormCarrier::Horizontal) e += added;
  }
}

/// The direction to `target` as read on the circles in `pointing`'s face, reduced to face 1, before the zero
/// is subtracted. a is the azimuth from the perpendicular of the arc plane, e the elevation over the horizon,
/// rad.
template <typename T>
Direction<T> circleDirection(const ErrorTerms<T>& errors, SpacePoint<T> target, const Pointing& pointing) {
  using std::asin, std::atan2, std::cos, std::sin, std::sqrt;
  using enum ErrorTerm;
  if (errors.isPerfect()) return observe(PlanePoint<T>{target.x, target.y}, T(-target.z), pointing.relation);
  const double side = pointing.face == 1 ? 1 : -1;
  if (pointing.isSetUpAgain) {
    target.x += errors[SetupShiftX];
    target.y += errors[SetupShiftY];
  }

  // Converts to the tilted instrument: rotates back about z, then about x.
  const T ct = cos(errors[VerticalAxisTiltZ]), st = sin(errors[VerticalAxisTiltZ]);
  const T right = target.x * ct + target.y * st, up0 = target.y * ct - target.x * st;
  const T cx = cos(errors[VerticalAxisTiltX]), sx = sin(errors[VerticalAxisTiltX]);
  const T up = up0 * cx + target.z * sx, forward = up0 * sx - target.z * cx;
  const T slant = sqrt(right * right + up * up + forward * forward);

  const T cc = cos(errors[Collimation]), sc = sin(errors[Collimation]);
  const T ci = cos(errors[TrunnionTilt]), si = sin(errors[TrunnionTilt]);
  const T sinE = (up / slant + sc * si) / (cc * ci);
  T e = asin(sinE);
  const T cosE = sqrt(1 - sinE * sinE);
  T a = atan2(right, forward) + side * atan2(T(sc * ci + cc * sinE * si), T(cc * cosE));

  // Up to here e follows the exact relation to y. Adds planar − exact times the share of the planar relation.
  const T planar = atan2(target.y, T(-target.z));
  const T exact = atan2(target.y, T(sqrt(target.x * target.x + target.z * target.z)));
  const double isPlanar = pointing.relation == VerticalAngleRelation::Planar ? 1 : 0;
  e += (isPlanar + (1 - 2 * isPlanar) * errors[VerticalAngleRelation]) * (planar - exact);

  constexpr double perTenDegrees = 18 / std::numbers::pi;
  e += errors[VerticalRefraction] * (perTenDegrees * perTenDegrees) * e * e;

  // Circle readings in this face.
  const T alpha = pointing.horizontalZero + a;
  a += side * (errors[HorizontalCircleSine] * sin(alpha) + errors[HorizontalCircleCosine] * cos(alpha));
  const double down = pointing.circle == VerticalCircle::Zenith ? 1 : -1;
  const double horizon = pointing.circle == VerticalCircle::Zenith ? std::numbers::pi / 2 : 0;
  const T beta1 = horizon - down * e;
  const double fullTurn = pointing.circle == VerticalCircle::Zenith ? 2 * std::numbers::pi : std::numbers::pi;
  const T beta = side > 0 ? beta1 : T(fullTurn - beta1);
  const T sinBeta = sin(beta), cosBeta = cos(beta);
  e -= down * side *
       (errors[VerticalIndex] + errors[VerticalCircleSine] * sinBeta +
        errors[VerticalCircleCosine] * cosBeta + errors[VerticalGraduationSine] * 2 * sinBeta * cosBeta +
        errors[VerticalGraduationCosine] * (1 - 2 * sinBeta * sinBeta));

  a += errors[HorizontalDrift] * pointing.elapsed;
  e -= down * errors[VerticalDrift] * pointing.elapsed;
  if (pointing.jumpShare != 0) {
    a += errors[HorizontalJump] * pointing.jumpShare;
    e -= down * pointing.jumpShare * errors[VerticalJump];
  }
  if (pointing.own) addOwn(errors, *pointing.own, a, e);
  return {a, e};
}

/// The slider reading at arc angle φ, rad. `distance`, mm, and `own` are for the user's own effects.
template <typename T>
T observeSlider(const ErrorTerms<T>& errors, const ArcPose<T>& arc, const T& phi, int axisDeg,
                double distance = 0, const OwnPlace* own = nullptr) {
  using std::sin;
  using enum ErrorTerm;
  const T s = sliderCoordinateOf(phi, axisDeg);
  if (errors.isPerfect()) return arc.sliderZero + s;
  const T read = arc.sliderZero + s + errors[SliderScale] * s + errors[SliderSine] * sin(s);
  return own ? T(read + ownDisplacementAt(errors, arc, distance, phi, axisDeg, *own).slider) : read;
}

}  // namespace alidade
