#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/adjustment/arc_fit.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

// The fit of `fitArc` for the usual case, fast: a pair of readings of a perfect theodolite for each place.
//
// Such a pair maps one-to-one onto the arc plane, X = L tan a, Y = L tan e sec a (planar: L tan e), so each
// place gives one condition without a latent arc angle. With the distance of the plane point from the
// current centre (ux, uy),
//
//   f = (ux² + uy² − R²)/(2R) = 0,   f − (ux δx + uy δy)/R − ρ = 0 after a step,   ρ = (R'² − R² −
//   |δ|²)/(2R),
//
// linear in the unknowns (δx, δy, ρ). Its weight is 1/(f_a² σ_h² + f_e² σ_v²), and it is linearised at the
// adjusted readings of the iteration before (errors in both circles, Pope 1972, "Some pitfalls to be avoided
// in the iterative adjustment of nonlinear problems"), so that the minimum is that of `fitArc`, not an
// algebraic one. Start: Kåsa's circle. Lengths are in units of L on the way.
//
// Refused, and left to the general fit: |a| or |e| above 45°, a residual above 0.002 rad (5 mm at 2.4 m),
// places that hardly fix a circle, no convergence in a few iterations.
//
// Four places, or four fits, go side by side through the processor's vector units where it has them. Sums are
// taken in one order whatever the processor and the number of threads.

/// What all readings have in common.
struct ArcSetup {
  double distance = 0;                            ///< L > 0, mm
  double sigmaHorizontal = 0, sigmaVertical = 0;  ///< of a reading, rad, > 0
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
};

struct FastArcFit {
  Circle circle;           ///< mm, y up
  Covariance3 cofactor{};  ///< of (Δx, Δy, R) from the stated σ, mm²
  double chiSquare = 0;    ///< Σ (v/σ)²; with n − 3 degrees of freedom
  int iterations = 0;
};

/// Observed minus adjusted, rad, one for each reading. May be empty where they are not wanted.
struct ReadingResiduals {
  std::span<double> horizontal = {}, vertical = {};
};

/// Fits one arc to n places, `a[i]`, `e[i]` in rad, each the mean of `rows[i]` rows of one visit; no `rows`:
/// of one. Absent where refused. Above some thousand places an evenly taken part of them is fitted first and
/// all of them in one or two passes from there, without memory for each of them.
std::optional<FastArcFit> fitArcFast(const ArcSetup& setup, std::span<const double> a,
                                     std::span<const double> e, std::span<const double> rows = {},
                                     const ReadingResiduals& residuals = {});

/// Fits `fits` arcs of the same number of places n each: reading `i` of fit `j` is `a[j * n + i]`. Entry `j`
/// of the result is absent where fit `j` is refused. The result does not depend on `threads`.
std::vector<std::optional<FastArcFit>> fitArcsFast(const ArcSetup& setup, std::size_t fits,
                                                   std::span<const double> a, std::span<const double> e,
                                                   int threads = 1);

}  // namespace alidade
