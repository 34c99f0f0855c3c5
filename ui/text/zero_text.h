#pragma once

#include <QString>
#include <cstddef>

#include "core/session/measurement.h"

namespace alidade::ui {

/// The mean of a pointing zero with its σ and the movement of the zero. `position`: index in the session.
/// Empty for a position that is not evaluated, and for a single sighting unless face 2 was ignored.
QString meanZeroText(const Examined& examined, std::size_t position);

}  // namespace alidade::ui
