#pragma once

#include <string_view>

#include "core/exchange/recognise.h"

namespace alidade {

/// What the beginning of a table tells of it. For `recognise`.
Recognised recogniseTable(std::string_view beginning);

}  // namespace alidade
