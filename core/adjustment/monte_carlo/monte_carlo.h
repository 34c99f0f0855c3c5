#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/session/measurement.h"

namespace alidade {

// The linear budget checked by propagating distributions (JCGM 101:2008). Each draw takes every reading, both
// pointing zeros of each position, the distance and, where it is known, the radius from its distribution
// about the value read, and fits anew: by the fast fit of arcs where they have nothing in common, by the
// forward model to second order about the fit where that is held against fits in general and agrees to a
// thousandth of σ, or else by those. Refits that are fast do not reach into the general ones' results by more
// than that.
//
// Zeros, distance and radius are normal with their stated σ. Readings, and the priors of effects estimated
// along, are normal with σ scaled by s0 as in the budget; where s0 rests on f degrees of freedom the whole
// draw is divided by √(χ²_f/f), which makes them Student with f (JCGM 101, 6.4.9). So σ comes out greater
// than the budget's by up to √(f/(f − 2)), which k makes up for there.

/// No more are made where their number is left open: some 200 MB.
inline constexpr std::size_t mostDrawsLeftOpen = 5'000'000;

struct MonteCarloOptions {
  /// ≥ 100. Empty: as many as it takes to tell whether the linear budget holds, up to `mostDrawsLeftOpen`.
  std::optional<std::size_t> draws = {};
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: as many as the machine has; the result does not depend on it
  /// Counts the draws as they are made, for others to watch; null: nobody does.
  std::atomic<std::size_t>* made = nullptr;
};

/// What the draws say of one quantity, mm. The interval is the probabilistically symmetric one (7.7.2): from
/// the r-th of M draws in order of size to the (r + q)-th, q the whole number next to pM and r the half of
/// M − q, rounded up.
struct Spread {
  double mean = 0, sigma = 0, low = 0, high = 0;
};

/// Does the linear budget hold (clause 8)?
enum class LinearPropagation {
  Validated,  ///< both ends of y ± U lie within the numerical tolerance of the interval's
  Refuted,    ///< one of them lies farther off than chance in the draws explains
  Undecided,  ///< too few draws to tell; not where their number was left open
};

struct CentreSpread {
  int axisDeg = 0;
  Spread x, y;
};

struct MonteCarlo {
  std::size_t draws = 0;   ///< that gave a result
  std::size_t failed = 0;  ///< whose fit did not settle or whose readings fixed no circle; left out
  std::uint64_t seed = 0;
  double coverage = 0.95;             ///< of the intervals
  std::vector<CentreSpread> centres;  ///< one for each axis

  /// Of Δd, with arcs at 0° and at 180°.
  std::optional<Spread> intersection;
  double tolerance = 0;  ///< δ: half a unit of the second significant digit of the budget's σ (7.9.2), mm
  double lowDifference = 0;   ///< |Δd − U − low|, mm
  double highDifference = 0;  ///< |Δd + U − high|, mm
  double endpointSigma = 0;   ///< standard uncertainty of an end of the interval from the number of draws, mm
  LinearPropagation linear = LinearPropagation::Undecided;
};

/// `fit` is what `fitSession` made of `measurement`. Empty where it was stopped, where no arc was fitted, or
/// where fewer than 100 draws gave a result.
std::optional<MonteCarlo> propagateDistributions(const Measurement& measurement, const SessionFit& fit,
                                                 const MonteCarloOptions& options = {},
                                                 const std::stop_token& stop = {});

}  // namespace alidade
