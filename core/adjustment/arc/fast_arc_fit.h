#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

// A fast version of `fitArc` for the usual case: one pair of readings of a perfect theodolite for each place.
//
// Such a pair maps one-to-one onto the arc plane, X = L tan a, Y = L tan e sec a (planar: L tan e), so each
// place gives one condition without a latent arc angle. With the distance (ux, uy) of the plane point from
// the current centre, the condition is f = (ux² + uy² − R²)/2 = 0. The condition after a step,
//
//   f − ux δx − uy δy − h = 0, h = (R'² − R² − |δ|²)/2,
//
// is linear in the unknowns (δx, δy, h). Its weight is 1/(f_a² σ_h² + f_e² σ_v²), with f_a = ∂f/∂a, f_e =
// ∂f/∂e. Internal lengths are in units of L.
//
// The start is Kåsa's circle. One step uses the true first and second derivatives of Σ (v/σ)², from a series
// about the readings whose terms grow with residual/R. The step reaches the minimum of `fitArc` for residuals
// of a few times 2″; its length and the omitted terms bound the remainder. If this bound is too large, the
// condition is linearised repeatedly at the adjusted readings of the iteration before (errors in both
// circles, Pope 1972, "Some pitfalls to be avoided in the iterative adjustment of nonlinear problems").
//
// The fast fit refuses |a| or |e| above 45°, residuals above 0.002 rad (5 mm at 2.4 m), places that hardly
// determine a circle, and slow convergence. The general fit takes these over.
//
// If there are many places, a part of them is fitted first. One step from the part's circle then uses all
// places. The error of this step grows with the square of its length; the gradients of the part before and
// after the step correct it.
//
// Four places, or four fits, are processed together by vector units if the processor has them. The order of
// summation is the same for every processor and number of threads.

/// Bound on the remaining way to the minimum, in units of R.
inline constexpr double usualTolerance = 1.5e-12;

/// Constants common to all readings.
struct ArcSetup {
  double distance = 0;                            ///< L > 0, mm
  double sigmaHorizontal = 0, sigmaVertical = 0;  ///< of a reading, rad, > 0
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
};

struct FastArcFit {
  Circle circle;           ///< mm, y up
  Covariance3 cofactor{};  ///< of (Δx, Δy, R) from the stated σ, mm²; relative error ≤ 1e-5
  double chiSquare = 0;    ///< Σ (v/σ)²; with n − 3 degrees of freedom
  int iterations = 0;
};

/// Observed minus adjusted, rad, one for each reading. Empty spans are not filled.
struct ReadingResiduals {
  std::span<double> horizontal = {}, vertical = {};
};

/// Fits one arc to n places, `a[i]`, `e[i]` in rad, each the mean of `rows[i]` rows of one visit; without
/// `rows`, one row each. Absent if refused. Above 32 768 places their equations are not stored, and the
/// cofactor from the second derivatives has a relative error of up to 1e-4 if residuals are systematic.
std::optional<FastArcFit> fitArcFast(const ArcSetup& setup, std::span<const double> a,
                                     std::span<const double> e, std::span<const double> rows = {},
                                     const ReadingResiduals& residuals = {});

/// Fits as many arcs of the same number of places n as `fits` has entries: reading `i` of fit `j` is `a[j * n
/// + i]`. Entry `j` stays empty if fit `j` is refused. The result is the same for any `threads`. `tolerance`:
/// of the way to the minimum, in units of R.
void fitArcsFast(const ArcSetup& setup, std::span<const double> a, std::span<const double> e,
                 std::span<std::optional<FastArcFit>> fits, int threads = 1,
                 double tolerance = usualTolerance);

}  // namespace alidade
