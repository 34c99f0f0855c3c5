#include "core/base/normal_order.h"

#include <boost/math/distributions/beta.hpp>
#include <cassert>

#include "core/base/statistics.h"

namespace alidade {

double normalScore(double rank, std::size_t count) {
  assert(rank >= 1 && rank <= static_cast<double>(count));
  return normalQuantile((rank - 0.375) / (static_cast<double>(count) + 0.25));
}

/// Φ of the i-th smallest has the distribution Beta(i, n + 1 − i).
double normalOrderQuantile(double probability, double rank, std::size_t count) {
  assert(rank >= 1 && rank <= static_cast<double>(count));
  const boost::math::beta_distribution<double> share(rank, static_cast<double>(count) + 1 - rank);
  return normalQuantile(boost::math::quantile(share, probability));
}

}  // namespace alidade
