#pragma once

#include <cmath>
#include <type_traits>

#include "core/base/eight.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

// The equations of foot_point.h, for one visit (T: double) or eight at once (T: Eight).

/// Weights of the readings: 1/σ, per radian.
struct Whitening {
  double horizontal = 0, vertical = 0, slider = 0;
};

/// The common quantities of all visits of an arc.
struct ArcView {
  double distance = 0;  ///< L > 0, mm
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
  Whitening whitening;
  double turn = 1;  ///< the slider reads s0 + turn · φ: 1 at axis 0°, −1 at 180°

  ArcView(const Measurement& measurement, int axisDeg);
};

/// A circle, and the slider reading at φ = 0 (rad).
struct ArcUnknowns {
  Circle circle;
  double sliderZero = 0;
};

/// A point of the arc, with the residuals and the derivatives of the readings at this point.
template <typename T>
struct alignas(sizeof(T)) Foot {
  T cosine{}, sine{};   ///< of the arc angle φ
  Direction<T> left{};  ///< mean reading minus the reading of a perfect instrument, radians
  T sliderLeft{};       ///< slider reading minus the model, radians; 0 without slider reading
  /// ∂(a, e)/∂(x, y, L) at the foot, per mm; a is independent of y.
  T aX{}, aL{}, eX{}, eY{}, eL{};
};

/// Sine and cosine of an angle, up to a common factor.
template <typename T>
struct Ratio {
  T above, below;
};

template <typename T>
[[gnu::always_inline]] inline T squareRoot(const T& x) {
  if constexpr (std::is_same_v<T, double>) {
    return std::sqrt(x);
  } else {
    T root;
    for (std::size_t i = 0; i < eight; ++i) root[i] = __builtin_sqrt(x[i]);
    return root;
  }
}

template <typename T>
[[gnu::always_inline]] inline T magnitude(const T& x) {
  return x < 0 ? -x : x;
}

/// Up to `smallAngle` the series below are exact to rounding.
inline constexpr double smallAngle = 1e-3;

template <typename T>
[[gnu::always_inline]] inline T angleOfSmall(const Ratio<T>& ratio) {
  const T t = ratio.above / ratio.below, tt = t * t;
  return t * (1 - tt * (1.0 / 3 - tt * (1.0 / 5)));
}

/// The horizontal distance, mm, by which tan e is multiplied: √`square` with `square` = x² + L²; L under the
/// planar relation.
template <typename T>
[[gnu::always_inline]] inline T groundTo(const ArcView& view, const T& square) {
  return view.relation == VerticalAngleRelation::Exact ? squareRoot(square) : T{} + view.distance;
}

/// Intersection of the line of sight with the arc plane, mm.
template <typename T>
[[gnu::always_inline]] inline PlanePoint<T> sightedAlong(const ArcView& view, const T& tanA, const T& tanE) {
  const T x = view.distance * tanA;
  return {x, groundTo<T>(view, x * x + view.distance * view.distance) * tanE};
}

/// Turns the direction of the foot to the sighted point.
template <typename T>
[[gnu::always_inline]] inline void turnTo(Foot<T>& foot, const PlanePoint<T>& sighted, const Circle& circle) {
  const T x = sighted.x - circle.x, y = sighted.y - circle.y;
  const T length = squareRoot<T>(x * x + y * y);
  foot.cosine = length > 0 ? x / length : T{} + 1;
  foot.sine = length > 0 ? y / length : T{};
}

/// Returns the residuals of the circle readings at the foot, as ratios, and fills the derivatives of `foot`.
template <typename T>
[[gnu::always_inline]] inline Direction<Ratio<T>> lookFrom(Foot<T>& foot, const ArcView& view,
                                                           const Circle& circle, const T& tanA,
                                                           const T& tanE) {
  const double l = view.distance;
  const T x = circle.x + circle.radius * foot.cosine, y = circle.y + circle.radius * foot.sine;
  const T square = x * x + l * l, perSquare = 1 / square;
  foot.aX = l * perSquare;
  foot.aL = -x * perSquare;
  const T ground = groundTo<T>(view, square);
  const T perBoth = 1 / (ground * (ground * ground + y * y)), perGround = -y * perBoth;
  foot.eX = view.relation == VerticalAngleRelation::Exact ? perGround * x : T{};
  foot.eY = ground * ground * perBoth;
  foot.eL = perGround * l;
  return {{tanA * l - x, l + x * tanA}, {tanE * ground - y, ground + y * tanE}};
}

/// ∂(a, e)/∂φ, in σ per rad.
template <typename T>
[[gnu::always_inline]] inline Direction<T> alongArc(const ArcView& view, double radius, const Foot<T>& foot) {
  return {-view.whitening.horizontal * radius * foot.sine * foot.aX,
          view.whitening.vertical * radius * (foot.cosine * foot.eY - foot.sine * foot.eX)};
}

/// Step from the foot to the minimum of |r(φ)|²/2, rad. The second derivative includes the curvature of the
/// arc, for faster convergence, and omits that of the projection. Far from the arc it omits both. `along`:
/// `alongArc`; `rows`, `sliderRows`: numbers of readings of each circle and of the slider.
template <typename T>
[[gnu::always_inline]] inline T footStep(const ArcView& view, double radius, const Foot<T>& foot,
                                         const Direction<T>& along, const T& rows, const T& sliderRows) {
  const double h = view.whitening.horizontal, v = view.whitening.vertical;
  const T sliderWeight = view.whitening.slider * view.whitening.slider * sliderRows;
  const T left = rows * (along.a * h * foot.left.a + along.e * v * foot.left.e) +
                 view.turn * sliderWeight * foot.sliderLeft;
  const T square = rows * (along.a * along.a + along.e * along.e) + sliderWeight;
  const T bend = rows * radius *
                 (h * h * foot.left.a * foot.cosine * foot.aX +
                  v * v * foot.left.e * (foot.sine * foot.eY + foot.cosine * foot.eX));
  return left / (square + (magnitude<T>(bend) < 0.1 * square ? bend : T{}));
}

/// Rotates the direction of the foot by a small angle.
template <typename T>
[[gnu::always_inline]] inline void turnBySmall(Foot<T>& foot, const T& angle) {
  const T square = angle * angle;
  const T c = 1 - square * (1.0 / 2 - square * (1.0 / 24));
  const T s = angle * (1 - square * (1.0 / 6 - square * (1.0 / 120)));
  const T cosine = foot.cosine;
  foot.cosine = cosine * c - foot.sine * s;
  foot.sine = cosine * s + foot.sine * c;
}

inline constexpr int mostFootSteps = 25;

/// Is the next step negligible? Steps shrink by a constant ratio, that of residual to radius. `size`,
/// `before`: lengths of this step and of the previous step, rad.
template <typename T>
[[gnu::always_inline]] inline auto isLastFootStep(const T& size, const T& before) {
  constexpr double smallest = 1e-14;  // rad; 4e-12 mm on a 400 mm arc
  constexpr double near = 1e-10;      // below this, the ratio predicts the next step
  return ((size < near) & (size * size < smallest * before)) | (size < smallest);
}

/// Updates the residuals after the last step, whose square is negligible, and keeps the derivatives.
template <typename T>
[[gnu::always_inline]] inline void followLastStep(Foot<T>& foot, const ArcView& view,
                                                  const Direction<T>& along, const T& step) {
  foot.left.a -= along.a / view.whitening.horizontal * step;
  foot.left.e -= along.e / view.whitening.vertical * step;
}

}  // namespace alidade
