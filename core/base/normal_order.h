#pragma once

#include <cstddef>

namespace alidade {

// The i-th smallest of n independent values of a standard normal distribution (1 ≤ i ≤ n; i may
// lie between two of them), for the plot of normal quantiles.

/// Its approximate expected value: the quantile of (i − 3/8)/(n + 1/4) (Blom, "Statistical Estimates and
/// Transformed Beta-Variables", 1958).
double normalScore(double rank, std::size_t count);

/// The value below which it is with `probability` in (0, 1).
double normalOrderQuantile(double probability, double rank, std::size_t count);

}  // namespace alidade
