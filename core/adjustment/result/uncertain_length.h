#pragma once

namespace alidade {

/// A vector in a plane, mm, with the variances and covariance of its components, mm².
struct UncertainVector {
  double x = 0, y = 0;
  double varianceX = 0, varianceY = 0, covariance = 0;
};

struct UncertainLength {
  double value = 0, sigma = 0;  ///< mm, ≥ 0
};

/// Computes the length to second order (JCGM 100:2008, 5.1.2, note), since the transverse uncertainty of a
/// short vector matters. u² is the lesser of u∥² + u⊥⁴/2|v|² and u∥² + u⊥².
UncertainLength lengthOf(const UncertainVector& vector);

}  // namespace alidade
