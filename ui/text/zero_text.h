#pragma once

#include <QString>
#include <cstddef>

#include "core/session/measurement.h"

namespace alidade::ui {

/// The mean of the sightings of a position's pointing zero, with its σ and by what the zero moved; empty
/// where it was sighted once or has none. `position` is an index into the session's.
QString meanZeroText(const Examined& examined, std::size_t position);

}  // namespace alidade::ui
