#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/exchange/import.h"

namespace alidade::fuzz {

/// Problems name lines and columns that exist in the text.
void checkPlaces(const Recording& recording, std::string_view text);

/// Imports a file as the console does: it is refused with a sentence, or yields a session that can be saved
/// and examined.
void importBytes(std::string_view bytes, const ImportOptions& options,
                 std::optional<std::size_t> turnedAtLine = {});

}  // namespace alidade::fuzz
