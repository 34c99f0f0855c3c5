#pragma once

#include <cstdint>

#include "core/base/angle.h"
#include "core/session/session.h"
#include "core/simulation/truth.h"

namespace alidade {

/// The use of the compensator in a simulated session.
enum class CompensatorUse {
  Off,       ///< the rows state that nothing was corrected
  Measured,  ///< the rows also state the tilts
  On,        ///< both circles are corrected for the tilt of the vertical axis
};

/// The truth with the compensator on: its setting error, drawn with `sigma` about both axes, replaces the
/// tilt of the vertical axis.
Truth leftByCompensator(Truth truth, Angle sigma, std::uint64_t seed);

/// Enters the instrument's statements in each row. With `Measured`, each tilt (cross and length) is that of
/// `truth` plus an index of the compensator and an error of the reading. Index and error are drawn with
/// `sigma`; the tilts are written to 0.1″.
void stateCompensator(Session& session, const Truth& truth, CompensatorUse use, Angle sigma,
                      std::uint64_t seed);

}  // namespace alidade
