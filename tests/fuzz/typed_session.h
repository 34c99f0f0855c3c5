#pragma once

#include <string_view>

#include "core/session/session.h"

namespace alidade::fuzz {

/// A session as typed so far. The bytes choose the guideway, the plan, the errors of the instrument and the
/// session's noise and model; then, byte by byte, the actions: rows typed as read, a digit wrong, two
/// swapped, a cell blank, rows moved, excluded or deleted, an option changed. At most `mostRows` rows. Empty
/// if no theodolite could read such a plan.
Session typedSession(std::string_view bytes);

inline constexpr std::size_t mostRows = 150;

}  // namespace alidade::fuzz
