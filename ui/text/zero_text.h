#pragma once

#include <QString>
#include <cstddef>

#include "core/session/measurement.h"

namespace alidade::ui {

/// The mean of a position's pointing zero with its σ and the movement of the zero; empty if sighted once or
/// absent. `position` is an index into the session's.
QString meanZeroText(const Examined& examined, std::size_t position);

}  // namespace alidade::ui
