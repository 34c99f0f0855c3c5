#pragma once

#include <cmath>
#include <limits>

namespace alidade {

/// Prior knowledge of a quantity: one more observation of it, in its own unit.
struct Prior {
  double value = 0;
  double sigma = std::numeric_limits<double>::infinity();  ///< ≥ 0; infinite: no prior knowledge

  bool isInformative() const { return !std::isinf(sigma); }
  // Terms of the whitened equation, in units of σ > 0; 0 without prior knowledge.
  /// Derivative with respect to the quantity.
  double derivative() const { return 1 / sigma; }
  /// Prior value minus the value `at`.
  double residual(double at) const { return (value - at) / sigma; }
  /// The contribution to the diagonal of the normal equations.
  double weight() const { return 1 / (sigma * sigma); }
};

}  // namespace alidade
