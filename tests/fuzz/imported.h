#pragma once

#include <string_view>

#include "core/exchange/import.h"

namespace alidade::fuzz {

/// Problems name lines and columns that the text has.
void checkPlaces(const Recording& recording, std::string_view text);

/// Imports a file as the console does: it is refused in words, or makes a session that can be kept and
/// examined.
void importBytes(std::string_view bytes, const ImportOptions& options);

}  // namespace alidade::fuzz
