#pragma once

#include <limits>
#include <optional>

namespace alidade {

// Numbers on their way to a distribution or a root. What a sum of squares or a variance can never be is kept
// out by type, so that no rounding and no loss of rank upstream reaches a function that has no answer to it:
// such a number is unknown, and unknown is an outcome.

/// Σ (v/σ)², or another squared distance in units of its own variance: 0 or more, may be infinite, or
/// unknown. Below zero by rounding (1e-6) is 0; farther below it is no square, hence unknown, as NaN is.
class Misfit {
 public:
  Misfit(double squared)
      : m_squared(squared >= 0          ? squared
                  : squared > -rounding ? 0
                                        : std::numeric_limits<double>::quiet_NaN()) {}

  bool isKnown() const { return m_squared >= 0; }
  double squared() const { return m_squared; }  ///< NaN where unknown

 private:
  static constexpr double rounding = 1e-6;
  double m_squared;
};

/// How many conditions check something: more than none, may be infinite, or there are none.
class DegreesOfFreedom {
 public:
  DegreesOfFreedom(double count) : m_count(count > 0 ? count : 0) {}

  static DegreesOfFreedom infinite() { return std::numeric_limits<double>::infinity(); }

  bool areThere() const { return m_count > 0; }
  bool areInfinite() const { return m_count == std::numeric_limits<double>::infinity(); }
  double count() const { return m_count; }  ///< 0 where there are none

 private:
  double m_count;
};

/// Probability that χ² exceeds a misfit. Absent where the misfit is unknown or nothing checks it.
std::optional<double> chiSquareUpperTail(Misfit chiSquare, DegreesOfFreedom degreesOfFreedom);

/// Probability that F exceeds a misfit of `numerator` conditions divided by their number. Absent where the
/// misfit is unknown or either has no degrees of freedom.
std::optional<double> fUpperTail(Misfit misfit, DegreesOfFreedom numerator, DegreesOfFreedom denominator);

/// k such that a Student variable (infinite degrees of freedom: normal) lies within ±k with probability
/// `coverage` in (0, 1). Infinite without degrees of freedom: then no interval is wide enough.
double coverageFactor(double coverage, DegreesOfFreedom degreesOfFreedom);

/// Probability that a Student variable (infinite degrees of freedom: normal) is less than `t`. Absent without
/// degrees of freedom, or where `t` is no number.
std::optional<double> studentLowerTail(double t, DegreesOfFreedom degreesOfFreedom);

/// Degrees of freedom of a combined σ of which `scaled`, estimated with `ofScaled`, is the only part that was
/// estimated (Welch-Satterthwaite, JCGM 100, G.4.1: ν (σ/scaled)⁴). Infinite where that part is nothing.
DegreesOfFreedom effectiveDegreesOfFreedom(double sigma, double scaled, DegreesOfFreedom ofScaled);

/// σ of a variance: below zero, by rounding, it is 0; NaN stays NaN.
double standardDeviation(double variance);

}  // namespace alidade
