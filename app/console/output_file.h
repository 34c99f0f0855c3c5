#pragma once

#include <optional>
#include <string>

#include "core/base/problem.h"

namespace alidade::console {

/// Writes a whole file; the sentence, with the file's name, where it cannot be written.
std::optional<Problem> writeFile(const std::string& path, const std::string& text);

}  // namespace alidade::console
