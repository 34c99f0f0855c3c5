#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace alidade {

// Argument types of distributions. Rounding or rank deficiency may cause impossible sums of squares and
// degrees of freedom. The types turn them into 0 or an unknown number: a valid outcome instead of an invalid
// argument.

/// Σ (v/σ)², or another squared distance in units of its own variance: 0 or more, may be infinite, or
/// unknown. A value between −1e-6 and 0, as from rounding, is 0; a more negative value and NaN are unknown.
class WeightedSquareSum {
 public:
  WeightedSquareSum(double value)
      : m_value(value >= 0          ? value
                : value > -rounding ? 0
                                    : std::numeric_limits<double>::quiet_NaN()) {}

  bool isKnown() const { return m_value >= 0; }
  double value() const { return m_value; }  ///< NaN if unknown

 private:
  static constexpr double rounding = 1e-6;
  double m_value;
};

/// The number of redundant conditions: positive, infinite, or 0 for none.
class DegreesOfFreedom {
 public:
  DegreesOfFreedom(double count) : m_count(count > 0 ? count : 0) {}

  static DegreesOfFreedom infinite() { return std::numeric_limits<double>::infinity(); }

  bool isPositive() const { return m_count > 0; }
  bool areInfinite() const { return m_count == std::numeric_limits<double>::infinity(); }
  double count() const { return m_count; }  ///< 0 if there are none

 private:
  double m_count;
};

/// A sum of the redundancies of readings, without the rounding error of a whole number.
double redundancyOf(double sum);

/// A test of readings fails if its p-value is smaller. A session undergoes some ten tests, so that chance
/// alone fails one in a hundred sessions.
inline constexpr double improbable = 0.001;

/// Probability that χ² exceeds the sum `chiSquare`. Absent for an unknown sum or no degrees of freedom.
std::optional<double> chiSquareUpperTail(WeightedSquareSum chiSquare, DegreesOfFreedom degreesOfFreedom);

/// Probability that F exceeds `squares` / `numerator`. Absent if `squares` is unknown or either number of
/// degrees of freedom is 0.
std::optional<double> fUpperTail(WeightedSquareSum squares, DegreesOfFreedom numerator,
                                 DegreesOfFreedom denominator);

/// k such that a Student variable (infinite degrees of freedom: normal) lies within ±k with probability
/// `coverage` in (0, 1). Infinite without degrees of freedom, as any finite interval is too narrow.
double coverageFactor(double coverage, DegreesOfFreedom degreesOfFreedom);

/// Probability that a Student variable (infinite degrees of freedom: normal) is less than `t`. Absent without
/// degrees of freedom, or if `t` is NaN.
std::optional<double> studentLowerTail(double t, DegreesOfFreedom degreesOfFreedom);

/// Degrees of freedom of a combined σ whose only estimated part is `scaled`, with `ofScaled` degrees of
/// freedom (Welch-Satterthwaite, JCGM 100, G.4.1: ν (σ/scaled)⁴). Infinite if that part is zero.
DegreesOfFreedom effectiveDegreesOfFreedom(double sigma, double scaled, DegreesOfFreedom ofScaled);

/// The square root of a variance; 0 if the variance is below zero, as by rounding. NaN stays NaN.
double standardDeviation(double variance);

/// z with Φ(z) = `probability` in (0, 1).
double normalQuantile(double probability);

/// The median of at least one value; of an even number, the mean of the two in the middle.
double medianOf(std::vector<double> values);

}  // namespace alidade
