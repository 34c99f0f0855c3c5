#pragma once

#include <QString>
#include <cstddef>

#include "core/session/measurement.h"

namespace alidade::ui {

/// The mean of a position's pointing zero with its σ and the movement of the zero. Empty without a zero, or
/// with a single sighting if no face was left out. `position`: index of the position in the session.
QString meanZeroText(const Examined& examined, std::size_t position);

}  // namespace alidade::ui
