#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/numerics/fit_status.h"

namespace alidade {

// Nonlinear least squares: minimise χ² = Σ (v/σ)² over some unknowns, from a start. A Gauss-Newton step is
// damped: the diagonal of the normal matrix N is multiplied by 1 + damping, so that units do not matter. If
// the step does not raise χ², it is taken and the next damping is ten times less; otherwise the step is
// repeated with ten times the damping.
//
// One number measures the distance from the minimum, with g = −½ ∂χ²/∂unknowns the right side of the normal
// equations:
//
//   λ = √(gᵀ N⁻¹ g)
//
// is the length of the undamped step in standard deviations of the result, and so measures step and gradient.
// λ² is the possible decrease of χ². Solvers that ignore the σ of their readings need three tolerances
// instead, for step, gradient and cost.
//
// Source: D. W. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", J. SIAM 11
// (1963).

struct LeastSquaresOptions {
  int maximumIterations = 100;  ///< rejected steps counted
  double tolerance = 1e-9;      ///< converged if λ < tolerance
  /// Converged only if also λ ≤ confirmation one step before, or √χ² at the start, of which λ is never more.
  /// If equations defer a part to the next step, as linear equations of the arc angles do, λ can be small by
  /// chance. Infinite: λ is reliable.
  double confirmation = std::numeric_limits<double>::infinity();
  double firstDamping = 1e-6;    ///< > 0
  double largestDamping = 1e12;  ///< `NoDescent` once the damping reaches it
};

/// `Problem` has
///   State, System values of the unknowns; normal equations there, with `chiSquare`
///   System system(State, System used) `used` is discarded: its memory may be reused
///   double remaining(System) λ; infinite if it cannot be computed
///   State moved(State, System, double damping)
///   bool isPossible(State) false: beyond a limit such as R = 0; no step leads there
template <typename Problem>
struct LeastSquaresMinimum {
  typename Problem::State state;
  typename Problem::System system = {};  ///< at `state`
  int iterations = 0;
  FitStatus status = FitStatus::TooManyIterations;
};

/// χ² rises by more than rounding. Readings are rounded to 1e-16 rad, some 1e-11 of their σ.
inline bool isRise(double before, double after) {
  constexpr double rounding = 1e-9;
  return !(after <= before + rounding * (1 + before));
}

template <typename Problem>
LeastSquaresMinimum<Problem> minimise(const Problem& problem, typename Problem::State start,
                                      const LeastSquaresOptions& options) {
  constexpr double smallestDamping = 1e-12;
  LeastSquaresMinimum<Problem> best{.state = std::move(start)};
  best.system = problem.system(best.state, {});
  double remaining = std::sqrt(best.system.chiSquare);
  const auto hasArrived = [&] {
    const double before = std::exchange(remaining, problem.remaining(best.system));
    return remaining < options.tolerance && before <= options.confirmation;
  };
  bool arrived = remaining <= options.confirmation && hasArrived();
  typename Problem::System spare;
  double damping = options.firstDamping;
  for (; !arrived && damping < options.largestDamping && best.iterations < options.maximumIterations;
       ++best.iterations) {
    typename Problem::State trial = problem.moved(best.state, best.system, damping);
    if (!problem.isPossible(trial)) {
      damping *= 10;
      continue;
    }
    typename Problem::System system = problem.system(trial, std::move(spare));
    if (isRise(best.system.chiSquare, system.chiSquare)) {
      spare = std::move(system);
      damping *= 10;
      continue;
    }
    best.state = std::move(trial);
    spare = std::exchange(best.system, std::move(system));
    damping = std::max(damping / 10, smallestDamping);
    arrived = hasArrived();
  }
  if (arrived)
    best.status = FitStatus::Converged;
  else if (!(damping < options.largestDamping))
    best.status = FitStatus::NoDescent;
  return best;
}

}  // namespace alidade
