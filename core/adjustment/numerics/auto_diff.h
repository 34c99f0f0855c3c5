#pragma once

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

// Automatic derivatives with respect to a fixed number of variables.

namespace Eigen {

/// Replaces Eigen's own, which returns derivatives of dynamic size: two allocations a call.
template <int count>
AutoDiffScalar<Matrix<double, count, 1>> atan2(const AutoDiffScalar<Matrix<double, count, 1>>& y,
                                               const AutoDiffScalar<Matrix<double, count, 1>>& x) {
  const double square = x.value() * x.value() + y.value() * y.value();
  return {std::atan2(y.value(), x.value()),
          (y.derivatives() * x.value() - y.value() * x.derivatives()) / square};
}

}  // namespace Eigen
