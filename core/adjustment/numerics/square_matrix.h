#pragma once

#include <cstddef>
#include <vector>

namespace alidade {

/// A dense square matrix as a plain value, row by row, so that results of an adjustment do not expose its
/// linear algebra library.
struct SquareMatrix {
  std::size_t size = 0;
  std::vector<double> values;  ///< size × size

  double operator()(std::size_t row, std::size_t column) const { return values[row * size + column]; }
};

}  // namespace alidade
