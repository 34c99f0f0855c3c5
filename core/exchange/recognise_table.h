#pragma once

#include <string_view>

#include "core/exchange/recognise.h"

namespace alidade {

/// Recognises a table by its beginning. For `recognise`.
Recognised recogniseTable(std::string_view beginning);

}  // namespace alidade
