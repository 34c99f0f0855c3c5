#pragma once

#include <string_view>

#include "core/session/session.h"

namespace alidade::fuzz {

/// A session as typed so far. The bytes choose the guideway, the plan, the errors of the instrument and the
/// session's noise and model. Then they choose the actions, byte by byte. Rows are typed as read, with a
/// wrong digit, two swapped, or a blank cell; rows are moved, excluded or deleted; an option is changed. At
/// most `mostRows` rows. Empty if no theodolite could read such a plan.
Session typedSession(std::string_view bytes);

inline constexpr std::size_t mostRows = 150;

}  // namespace alidade::fuzz
