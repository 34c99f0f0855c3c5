#include "core/base/statistics.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>

namespace alidade {

double chiSquareUpperTail(double chiSquare, double degreesOfFreedom) {
  assert(degreesOfFreedom > 0 && chiSquare >= 0);
  // Chernoff's bound, P(χ² ≤ x) ≤ (r e^(1−r))^(f/2) with r = x/f < 1: where it is lost beside 1 the tail is
  // 1, and the series of the gamma function, which overflows there, is not asked.
  const double ratio = chiSquare / degreesOfFreedom;
  constexpr double lostBesideOne = -40;  // e^−40 is below half of the spacing of doubles at 1
  if (ratio < 1 && degreesOfFreedom / 2 * (1 - ratio + std::log(ratio)) < lostBesideOne) return 1;
  return boost::math::cdf(complement(boost::math::chi_squared(degreesOfFreedom), chiSquare));
}

double fUpperTail(double ratio, double numerator, double denominator) {
  assert(ratio >= 0 && numerator > 0 && denominator > 0);
  if (std::isinf(denominator)) return chiSquareUpperTail(ratio * numerator, numerator);
  return boost::math::cdf(complement(boost::math::fisher_f(numerator, denominator), ratio));
}

double coverageFactor(double coverage, double degreesOfFreedom) {
  assert(coverage > 0 && coverage < 1 && degreesOfFreedom > 0);
  const double outside = (1 - coverage) / 2;
  if (std::isinf(degreesOfFreedom)) return boost::math::quantile(complement(boost::math::normal(), outside));
  return boost::math::quantile(complement(boost::math::students_t(degreesOfFreedom), outside));
}

}  // namespace alidade
