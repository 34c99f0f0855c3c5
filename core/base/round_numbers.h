#pragma once

namespace alidade {

/// The largest of … 0.1, 0.2, 0.5, 1, 2, 5, 10 … that is not above `value` (> 0, finite).
double roundDown125(double value);

/// The smallest of … 0.1, 0.2, 0.5, 1, 2, 5, 10 … that is not below `value` (> 0, finite).
double roundUp125(double value);

/// Decimals needed to write multiples of a 1-2-5 step: 0 for 5, 1 for 0.2.
int decimalsOfStep(double step);

}  // namespace alidade
