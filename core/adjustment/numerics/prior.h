#pragma once

#include <cmath>
#include <limits>

namespace alidade {

/// What is known of a quantity before anything is read: one more observation of it, in its own unit.
struct Prior {
  double value = 0;
  double sigma = std::numeric_limits<double>::infinity();  ///< ≥ 0; infinite: nothing is known

  bool isInformative() const { return !std::isinf(sigma); }
  // Among whitened equations, that is in units of σ > 0; 0 where nothing is known.
  /// By the quantity.
  double derivative() const { return 1 / sigma; }
  /// Observed minus where the quantity is.
  double residual(double at) const { return (value - at) / sigma; }
  /// What it adds to the diagonal of the normal equations.
  double weight() const { return 1 / (sigma * sigma); }
};

}  // namespace alidade
