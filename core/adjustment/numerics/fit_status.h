#pragma once

#include <cstdint>

namespace alidade {

/// Why a fit ended. Outcomes, not errors.
enum class FitStatus : std::uint8_t {
  Converged,          ///< the minimum is nearer than the tolerance
  TooManyIterations,  ///< it was still on its way
  NoDescent,          ///< it is not at the minimum, and yet no step, however short, lowers χ²
  Undetermined,       ///< the equations have lost their rank: its numbers mean nothing
};

}  // namespace alidade
