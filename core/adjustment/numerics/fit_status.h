#pragma once

#include <cstdint>

namespace alidade {

/// The outcome of a fit.
enum class FitStatus : std::uint8_t {
  Converged,          ///< the minimum is nearer than the tolerance
  TooManyIterations,  ///< the iterations were used up before the minimum
  NoDescent,          ///< not at the minimum, but no step, however short, lowers χ²
  Undetermined,       ///< the equations are rank-deficient: the results are meaningless
};

}  // namespace alidade
