#pragma once

#include <string_view>

#include "core/session/session.h"

namespace alidade::fuzz {

/// A session as somebody has typed it so far. The bytes choose the guideway, the plan, the errors of the
/// instrument and what the session says of noise and model; then, byte by byte, what is done: rows typed as
/// read, a digit wrong, two swapped, a cell blank, rows moved, excluded or deleted, an option changed. At
/// most `mostRows` rows. Empty where no theodolite could read such a plan.
Session typedSession(std::string_view bytes);

inline constexpr std::size_t mostRows = 150;

}  // namespace alidade::fuzz
