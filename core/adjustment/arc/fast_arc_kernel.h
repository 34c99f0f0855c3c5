#pragma once

#include <cstddef>
#include <numbers>

#include "core/adjustment/arc/fast_arc_fit.h"

// The arithmetic of fast_arc_fit.cpp. Four lanes hold four places of one arc, or one place of four arcs.
// fast_arc_kernel.cpp is compiled twice: for every processor, and for those with vector units of four
// doubles. Every function here is inlined where it is called, so that the two compilations share none.

namespace alidade::arc_kernel {

constexpr std::size_t width = 4;
constexpr std::size_t sideBySide = 2;  // sets of lanes
using Lanes = double __attribute__((vector_size(width * sizeof(double))));

constexpr double largestAngle = std::numbers::pi / 4;
constexpr double largestResidual = 0.002;  // rad; the series are exact to rounding up to this
constexpr double remainderFactor = 6;      // bound on the remainder of an iteration, in units of its estimate
constexpr double straight = 1e-10;  // least product of variances across and along the chord, in R⁴; 6° of arc
constexpr int mostIterations = 12;

/// A pair of readings, and its equation in the last iteration.
struct alignas(sizeof(Lanes)) PlaceEquation {
  Lanes tanA, tanE, secA;  ///< secA: with the exact relation only
  Lanes y, perRise;        ///< height of the plane point, and its derivative with respect to e
  Lanes weight;            ///< rows of the visit, 0 for unused lanes; used if all lanes are of one arc
  Lanes w, perA, perE;     ///< misclosure, and the residuals of a and e per unit of it
  Lanes ux, uy;            ///< the plane point minus the centre
};

/// A circle in units of L.
template <typename T>
struct Disc {
  T x, y, square;  ///< R²
};

/// A step of the centre, and h of fast_arc_fit.h as `half`.
template <typename T>
struct Step {
  T x, y, half;
};

/// Σ weight · (products of ux, uy and 1).
template <typename T>
struct Information {
  T one{}, x{}, y{}, xx{}, xy{}, yy{};
};

/// `Information`, and Σ weight · w · (1, ux, uy, w) with the misclosure w.
template <typename T>
struct Normals : Information<T> {
  T w{}, xw{}, yw{}, ww{};
};

/// The normal equations from the condition linearised at adjusted readings.
template <typename T>
struct Sums : Normals<T> {
  T xxw{}, xyw{};
};

/// The normal equations from the series about the readings; `third` measures its terms of third order.
template <typename T>
struct CloseSums : Normals<T> {
  T third{};
};

struct Variances {
  double horizontal, vertical;  // rad²
};

struct Setup {
  Variances variances;
  double distance;
  bool exact;
  double tolerance;
};

/// Inverse of the normal equations. The fit is refused unless `determinacy` exceeds `straight`.
template <typename T>
struct Inverse {
  T xx, xy, yy, xh, yh, hh;
  T determinacy;
};

/// The state of the iteration. `remaining` bounds the way to the minimum, in units of R; `chance` is the part
/// of this bound due to residuals; `lag`: distance of the points of linearisation from the adjusted points;
/// `anisotropy`: how much a place's error depends on direction, 0…1.
template <typename T>
struct Progress {
  Disc<T> disc;
  Step<T> step{};
  T perRootPlaces{}, anisotropy = T{} + 1, lag{}, chance{}, remaining = T{} + 1, chiSquare{};
  Inverse<T> inverse;
};

/// The sums that determine Kåsa's circle through the places (see algebraic_circle.h).
template <typename T>
struct Moments {
  T n{}, x{}, y{}, xx{}, xy{}, yy{}, xz{}, yz{};
};

/// Readings of one arc, four places per vector.
struct Readings {
  const double *a, *e, *rows;  ///< rows: null if every visit has one row
  std::size_t count;

  std::size_t blocks() const { return (count + width - 1) / width; }
};

/// The results of a sweep over places.
template <typename S>
struct Found {
  S sums;
  double largestReading = 0, largestResidual = 0;
};

using Sweep = Found<Sums<double>>;
using Survey = Found<CloseSums<double>>;

/// The reported result: mm, mm².
template <typename T>
struct Conclusion {
  T x, y, radius, xx, xy, yy, xr, yr, rr, chiSquare;
  T sound;  ///< 0 if the fit is refused
  int iterations;
};

template <typename T>
struct alignas(sizeof(Lanes)) Outcome {
  Progress<T> progress;
  T largestReading{}, largestResidual{};
  int iterations = 0;
  double tolerance = usualTolerance;
};

template <typename T>
[[gnu::always_inline]] inline T larger(const T& p, const T& q) {
  return p > q ? p : q;
}

template <typename T>
[[gnu::always_inline]] inline T magnitude(const T& p) {
  return p < 0 ? -p : p;
}

[[gnu::always_inline]] inline Lanes broadcast(double value) {
  return Lanes{} + value;
}

[[gnu::always_inline]] inline double root(double x) {
  return __builtin_sqrt(x);
}

[[gnu::always_inline]] inline Lanes root(const Lanes& x) {
  Lanes result;
  for (std::size_t i = 0; i < width; ++i) result[i] = __builtin_sqrt(x[i]);
  return result;
}

template <typename T>
[[gnu::always_inline]] inline Inverse<T> invert(const Information<T>& sums, const T& square) {
  const T inverse = 1 / sums.one;
  const T x = sums.x * inverse, y = sums.y * inverse;
  const T xx = sums.xx - sums.x * x, xy = sums.xy - sums.x * y, yy = sums.yy - sums.y * y;
  const T determinant = xx * yy - xy * xy;
  const T ratio = 1 / determinant;
  Inverse<T> q;
  q.xx = yy * ratio;
  q.xy = -xy * ratio;
  q.yy = xx * ratio;
  q.xh = -(x * q.xx + y * q.xy);
  q.yh = -(x * q.xy + y * q.yy);
  q.hh = inverse - x * q.xh - y * q.yh;
  q.determinacy = determinant * inverse * inverse / (square * square);
  return q;
}

template <typename T>
[[gnu::always_inline]] inline Step<T> times(const Inverse<T>& q, const T& x, const T& y, const T& half) {
  return {q.xx * x + q.xy * y + q.xh * half, q.xy * x + q.yy * y + q.yh * half,
          q.xh * x + q.yh * y + q.hh * half};
}

/// Returns how much a place's error depends on direction: 0 (not at all) … 1. `square`: the square of the
/// largest reading, rad².
template <typename T>
[[gnu::always_inline]] inline T anisotropyOf(const Variances& variances, const T& square) {
  const double ratio = variances.horizontal / variances.vertical;
  const T unlike = larger(ratio, 1 / ratio) * (1 + 4 * square) - 1;
  return unlike < 1 ? unlike : T{} + 1;
}

/// Returns an upper bound of the length of the step, in units of R.
template <typename T>
[[gnu::always_inline]] inline T extent(const Step<T>& step, const T& perRadius, const T& perSquare) {
  return (magnitude(step.x) + magnitude(step.y)) * perRadius + magnitude(step.half) * perSquare;
}

template <typename T>
[[gnu::always_inline]] inline Disc<T> moved(const Disc<T>& disc, const Step<T>& step) {
  return {disc.x + step.x, disc.y + step.y, disc.square + 2 * step.half + step.x * step.x + step.y * step.y};
}

/// Root mean square distance of the places from the circle, in units of R.
template <typename T>
[[gnu::always_inline]] inline T scatter(const Normals<T>& sums, const T& perSquare) {
  return root(sums.ww / sums.one) * perSquare;
}

/// The largest ratio of an error of the circle to the distances it causes at the places, in units of R.
template <typename T>
[[gnu::always_inline]] inline T gainOf(const Inverse<T>& q, const T& one, const T& square) {
  return root((q.xx * square + q.yy * square + q.hh) * one);
}

/// Takes a step with these derivatives. The derivatives belong to the circle before the step, so the step
/// overshoots by the square of its length. `stretch` removes most of the excess; the rest depends on how far
/// places moved. `chance`, the other remainder, has either sign and is the third order of the residuals:
/// smaller if a place's error depends less on direction, larger on shorter arcs. The coefficients keep each
/// of the million arcs of tests/bench/fast_agreement.cpp within 1e-9 mm.
template <typename T>
[[gnu::always_inline]] inline void advance(Progress<T>& progress, const CloseSums<T>& sums) {
  const T square = progress.disc.square, perSquare = 1 / square, perOne = 1 / sums.one;
  const Inverse<T> q = invert(sums, square);
  Step<T> step = times(q, sums.xw, sums.yw, sums.w);
  const T way = sums.xw * step.x + sums.yw * step.y + sums.w * step.half;
  progress.chiSquare = sums.ww - way;
  const T stretch = 1 + 2 * perSquare * step.half;
  step = {step.x * stretch, step.y * stretch, step.half * stretch};
  const T gain = gainOf(q, sums.one, square);
  const T nonlinear = gain * root(progress.chiSquare * perOne) * perSquare;
  progress.chance = (0.07 + 0.12 * progress.anisotropy + 0.017 * gain) * gain * perSquare *
                    root(sums.third * perOne) * (progress.perRootPlaces + 100 * nonlinear);
  progress.remaining = gain * perSquare * (5 + 1.5 * gain) * way * perOne * perSquare + progress.chance;
  progress.step = step;
  progress.disc = moved(progress.disc, step);
  progress.inverse = q;
}

/// One Newton step. Only the weight of the condition, and the rotation of its normal, are nonlinear in the
/// centre. The term of the rotation, Σ weight · w (1 − n nᵀ), is subtracted from the step; its size bounds
/// later steps.
template <typename T>
[[gnu::always_inline]] inline void advance(Progress<T>& progress, const Sums<T>& sums) {
  const T square = progress.disc.square, perSquare = 1 / square, perRadius = root(perSquare);
  const Inverse<T> q = invert(sums, square);
  Step<T> step = times(q, sums.xw, sums.yw, sums.w);
  progress.chiSquare = sums.ww - sums.xw * step.x - sums.yw * step.y - sums.w * step.half;
  const T xx = sums.w - sums.xxw * perSquare, xy = -sums.xyw * perSquare, yy = sums.xxw * perSquare;
  const Step<T> turn = times(q, xx * step.x + xy * step.y, xy * step.x + yy * step.y, T(step.x - step.x));
  // A place linearised at a distance ε from its adjusted point misses the circle by ε²/2R. The error ε/R of
  // its normal, times its residual, adds an error of either sign. The geometry enlarges both. Two more errors
  // remain after the step: part of the subtracted `turn`, and a random part of the residuals, `chance`.
  const T residual = scatter(sums, perSquare);
  const T gain = gainOf(q, sums.one, square);
  const T stepLength = extent(step, perRadius, perSquare), off = stepLength + progress.lag;
  const T nonlinear = gain * residual;  // 3e-4 for 2″ on the usual arc
  const T chance = nonlinear * (stepLength + progress.lag) * (progress.perRootPlaces + 100 * nonlinear);
  progress.remaining =
      remainderFactor * (extent(turn, perRadius, perSquare) + chance + gain * 0.5 * off * off);
  progress.lag = (0.5 * off + residual) * off;
  step = {step.x - turn.x, step.y - turn.y, step.half - turn.half};
  progress.step = step;
  progress.disc = moved(progress.disc, step);
  progress.inverse = q;
}

[[gnu::always_inline]] inline Disc<Lanes> broadcast(const Disc<double>& disc) {
  return {broadcast(disc.x), broadcast(disc.y), broadcast(disc.square)};
}

[[gnu::always_inline]] inline Step<Lanes> broadcast(const Step<double>& step) {
  return {broadcast(step.x), broadcast(step.y), broadcast(step.half)};
}

[[gnu::always_inline]] inline const Disc<Lanes>& broadcast(const Disc<Lanes>& disc) {
  return disc;
}

[[gnu::always_inline]] inline const Step<Lanes>& broadcast(const Step<Lanes>& step) {
  return step;
}

/// Converts an outcome from units of L to mm, and decides whether the fit is refused.
template <typename T>
[[gnu::always_inline]] inline Conclusion<T> concluded(const Outcome<T>& outcome, double distance) {
  const auto& [disc, step, perRootPlaces, anisotropy, lag, chance, remaining, chiSquare, q] =
      outcome.progress;
  const T radius = root(disc.square), unit = T{} + distance * distance, mixed = unit / radius;
  const auto isSound = (outcome.largestReading <= largestAngle) &
                       (outcome.largestResidual <= largestResidual) & (remaining < outcome.tolerance) &
                       (q.determinacy > straight) & (disc.square > 0);
  return {disc.x * distance,
          disc.y * distance,
          radius * distance,
          q.xx * unit,
          q.xy * unit,
          q.yy * unit,
          q.xh * mixed,
          q.yh * mixed,
          q.hh * mixed / radius,
          chiSquare,
          isSound ? T{} + 1 : T{},
          outcome.iterations};
}

/// The functions over many places, for one kind of processor.
struct ArcKernel {
  /// Fits one arc. `places`: room for the blocks of the readings.
  void (*solveOne)(PlaceEquation* places, const Readings& readings, const Setup& setup,
                   const ReadingResiduals& residuals, Outcome<double>& outcome);
  /// Fits up to `width` · `sideBySide` arcs of `count` places each.
  void (*solveMany)(PlaceEquation* places, const double* a, const double* e, std::size_t count,
                    std::size_t fits, const Setup& setup, Conclusion<Lanes>* conclusions);
  /// Sums of all places at a circle, without storing their equations.
  void (*sweep)(const Readings& readings, const Setup& setup, const Disc<double>& at,
                const ReadingResiduals& residuals, Sweep& result);
  void (*survey)(const Readings& readings, const Setup& setup, const Disc<double>& at, Survey& result);
};

extern const ArcKernel plainKernel;  ///< for every processor
extern const ArcKernel wideKernel;   ///< for AVX2 with fused multiplication and addition

}  // namespace alidade::arc_kernel
