#include "core/base/statistics.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>

namespace alidade {

double chiSquareUpperTail(double chiSquare, double degreesOfFreedom) {
  assert(degreesOfFreedom > 0 && chiSquare >= 0);
  return boost::math::cdf(complement(boost::math::chi_squared(degreesOfFreedom), chiSquare));
}

double coverageFactor(double coverage, double degreesOfFreedom) {
  assert(coverage > 0 && coverage < 1 && degreesOfFreedom > 0);
  const double outside = (1 - coverage) / 2;
  if (std::isinf(degreesOfFreedom)) return boost::math::quantile(complement(boost::math::normal(), outside));
  return boost::math::quantile(complement(boost::math::students_t(degreesOfFreedom), outside));
}

}  // namespace alidade
