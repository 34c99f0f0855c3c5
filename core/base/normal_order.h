#pragma once

#include <cstddef>

namespace alidade {

// The i-th smallest of n independent values of a standard normal distribution, for the plot of normal
// quantiles. 1 ≤ i ≤ n; i may be fractional.

/// The approximate expected value of the i-th smallest: the quantile of (i − 3/8)/(n + 1/4) (Blom,
/// "Statistical Estimates and Transformed Beta-Variables", 1958).
double normalScore(double rank, std::size_t count);

/// The value that the i-th smallest falls below with `probability` in (0, 1).
double normalOrderQuantile(double probability, double rank, std::size_t count);

}  // namespace alidade
