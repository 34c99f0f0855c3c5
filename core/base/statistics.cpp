#include "core/base/statistics.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace alidade {

namespace {

namespace policies = boost::math::policies;

/// Beyond the range of doubles a quantile is infinite and a tail 0 or 1, without exceptions.
using Quiet = policies::policy<
    policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
    policies::overflow_error<policies::ignore_error>, policies::underflow_error<policies::ignore_error>,
    policies::evaluation_error<policies::ignore_error>>;

/// Computes in double: long double takes several times as long for digits that are not used.
using QuietAndQuick = policies::normalise<Quiet, policies::promote_double<false>>::type;

std::optional<double> known(double probability) {
  return std::isnan(probability) ? std::nullopt : std::optional(probability);
}

}  // namespace

double redundancyOf(double sum) {
  constexpr double rounding = 1e-6;
  const double whole = std::round(sum);
  return std::abs(sum - whole) < rounding ? whole : sum;
}

std::optional<double> chiSquareUpperTail(WeightedSquareSum chiSquare, DegreesOfFreedom degreesOfFreedom) {
  if (!chiSquare.isKnown() || !degreesOfFreedom.isPositive()) return std::nullopt;
  const double f = degreesOfFreedom.count(), ratio = chiSquare.value() / f;
  if (std::isinf(chiSquare.value())) return 0;
  // Chernoff's bound, P(χ² ≤ x) ≤ (r e^(1−r))^(f/2) with r = x/f < 1: if it is negligible compared with 1 the
  // tail is 1, which avoids an overflow in the series of the gamma function.
  constexpr double negligibleLog = -40;  // e^−40 is below half of the spacing of doubles at 1
  if (ratio < 1 && f / 2 * (1 - ratio + std::log(ratio)) < negligibleLog) return 1;
  return known(boost::math::cdf(
      complement(boost::math::chi_squared_distribution<double, QuietAndQuick>(f), chiSquare.value())));
}

std::optional<double> fUpperTail(WeightedSquareSum squares, DegreesOfFreedom numerator,
                                 DegreesOfFreedom denominator) {
  if (!squares.isKnown() || !numerator.isPositive() || !denominator.isPositive()) return std::nullopt;
  if (denominator.areInfinite()) return chiSquareUpperTail(squares, numerator);
  if (std::isinf(squares.value())) return 0;
  return known(boost::math::cdf(
      complement(boost::math::fisher_f_distribution<double, Quiet>(numerator.count(), denominator.count()),
                 squares.value() / numerator.count())));
}

double coverageFactor(double coverage, DegreesOfFreedom degreesOfFreedom) {
  assert(coverage > 0 && coverage < 1);
  if (!degreesOfFreedom.isPositive()) return std::numeric_limits<double>::infinity();
  const double outside = (1 - coverage) / 2;
  if (degreesOfFreedom.areInfinite())
    return boost::math::quantile(complement(boost::math::normal_distribution<double, Quiet>(), outside));
  return boost::math::quantile(complement(
      boost::math::students_t_distribution<double, QuietAndQuick>(degreesOfFreedom.count()), outside));
}

std::optional<double> studentLowerTail(double t, DegreesOfFreedom degreesOfFreedom) {
  if (!degreesOfFreedom.isPositive() || std::isnan(t)) return std::nullopt;
  if (std::isinf(t)) return t < 0 ? 0 : 1;
  if (degreesOfFreedom.areInfinite())
    return known(boost::math::cdf(boost::math::normal_distribution<double, Quiet>(), t));
  return known(
      boost::math::cdf(boost::math::students_t_distribution<double, Quiet>(degreesOfFreedom.count()), t));
}

DegreesOfFreedom effectiveDegreesOfFreedom(double sigma, double scaled, DegreesOfFreedom ofScaled) {
  if (ofScaled.areInfinite() || !(scaled > 0)) return DegreesOfFreedom::infinite();
  return ofScaled.count() * std::pow(sigma / scaled, 4);
}

double standardDeviation(double variance) {
  return std::sqrt(variance < 0 ? 0 : variance);
}

double normalQuantile(double probability) {
  assert(probability > 0 && probability < 1);
  return boost::math::quantile(boost::math::normal_distribution<double, QuietAndQuick>(), probability);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : std::midpoint(*middle, *std::max_element(values.begin(), middle));
}

}  // namespace alidade
