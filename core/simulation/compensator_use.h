#pragma once

#include <cstdint>

#include "core/base/angle.h"
#include "core/session/session.h"
#include "core/simulation/truth.h"

namespace alidade {

/// How the instrument of a simulated session uses its compensator.
enum class CompensatorUse {
  Off,       ///< the rows state that nothing was corrected
  Measured,  ///< they state the tilts, too
  On,        ///< the tilt of the vertical axis is taken off both circles
};

/// The truth that is left where the compensator is on: instead of the tilt its setting error, drawn with this
/// σ about both axes.
Truth leftByCompensator(Truth truth, Angle sigma, std::uint64_t seed);

/// Enters in each row what the instrument tells. Tilts are those of `truth`, off by an index of the
/// compensator for cross and length each, and by an error of each reading, both drawn with this σ; written to
/// 0.1″.
void stateCompensator(Session& session, const Truth& truth, CompensatorUse use, Angle sigma,
                      std::uint64_t seed);

}  // namespace alidade
