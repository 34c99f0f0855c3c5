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

// Checks the linear budget by propagating distributions (JCGM 101:2008). Each draw takes every input from its
// distribution about the value read, and fits again. The inputs are readings, both pointing zeros of each
// position, the distance and, if known, the radius. If the arcs are independent, the draws use the fast fit
// of arcs. Otherwise they use the forward model to second order about the fit. If this model deviates from
// general fits by more than a thousandth of σ or is too large for the memory, they use general fits.
//
// Zeros, distance, radius and the priors of estimated effects are normal with their stated σ. Readings, and
// zeros that scatter like them, are normal with σ scaled by s0 as in the budget. If s0 has f degrees of
// freedom, each draw divides s0 by √(χ²_f/f), which gives Student's distribution with f (JCGM 101, 6.4.9).
// The σ of the draws exceeds the budget's by up to √(f/(f − 2)), for which k compensates in the budget.

/// Maximum number of draws if their number is unspecified: some 200 MB of memory.
inline constexpr std::size_t mostDrawsLeftOpen = 5'000'000;

struct MonteCarloOptions {
  /// ≥ 100. Empty: as many as needed to decide whether the linear budget holds, up to `mostDrawsLeftOpen`.
  std::optional<std::size_t> draws = {};
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: as many as the machine has; the result is the same for any number
  /// Counts finished draws for a progress display; may be null.
  std::atomic<std::size_t>* made = nullptr;
};

/// The distribution of one quantity over the draws, mm. The interval is the probabilistically symmetric one
/// (7.7.2): from the r-th of M draws in order of size to the (r + q)-th, where q is the integer nearest to pM
/// and r is half of M − q, rounded up.
struct Spread {
  double mean = 0, sigma = 0, low = 0, high = 0;
};

/// Does the linear budget hold (clause 8)? With `mostDrawsLeftOpen` draws, chance no longer counts.
enum class LinearPropagation {
  Validated,  ///< both ends of Δd ± U are within the numerical tolerance of the interval's ends
  Refuted,    ///< an end deviates by more than the tolerance and chance in the draws
  Undecided,  ///< too few draws to decide; only if their number was specified
};

struct CentreSpread {
  int axisDeg = 0;
  Spread x, y;
};

struct MonteCarlo {
  std::size_t draws = 0;   ///< with a result
  std::size_t failed = 0;  ///< left out, as the fit did not converge or the readings determined no circle
  std::uint64_t seed = 0;
  double coverage = 0.95;             ///< of the intervals
  std::vector<CentreSpread> centres;  ///< one for each axis

  /// The spread of Δd; absent without an arc at 0° or at 180°.
  std::optional<Spread> intersection;
  double tolerance = 0;  ///< δ: half a unit of the second significant digit of the budget's σ (7.9.2), mm
  double lowDifference = 0;   ///< |Δd − U − low|, mm
  double highDifference = 0;  ///< |Δd + U − high|, mm
  double endpointSigma = 0;   ///< standard uncertainty of an end of the interval from the number of draws, mm
  LinearPropagation linear = LinearPropagation::Undecided;
};

/// `fit` is the result of `fitSession` for `measurement`. Empty if it was stopped, if no arc was fitted, or
/// if fewer than 100 draws gave a result.
std::optional<MonteCarlo> propagateDistributions(const Measurement& measurement, const SessionFit& fit,
                                                 const MonteCarloOptions& options = {},
                                                 const std::stop_token& stop = {});

}  // namespace alidade
