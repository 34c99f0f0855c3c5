#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace alidade {

/// Values counted in classes of equal width. Class i contains lower(i) ≤ value < lower(i + 1); the last one
/// also contains its upper limit.
struct Histogram {
  double width = 1;  ///< width of a class: 1, 2 or 5 times a power of ten
  double first = 0;  ///< the lower limit of the first class, a multiple of the width
  std::vector<std::size_t> counts;
  std::size_t outside = 0;  ///< values in no class

  double lower(std::size_t index) const { return first + static_cast<double>(index) * width; }
  double end() const { return lower(counts.size()); }
  std::optional<std::size_t> classOf(double value) const;
  std::size_t largestCount() const;
};

/// Counts finite values in classes that cover ±`reach` (> 0). Their width is 2 q/n^⅓, rounded up, with the
/// interquartile range q of n values (Freedman and Diaconis, "On the histogram as a density estimator",
/// 1981). There are at most 62 classes.
Histogram histogram(std::span<const double> values, double reach);

/// Values of a normal distribution about zero.
struct NormalValues {
  std::size_t count = 0;
  double sigma = 1;  ///< above 0
};

/// The expected number of values between `lower` and `upper`.
double expectedBetween(std::span<const NormalValues> values, double lower, double upper);

}  // namespace alidade
