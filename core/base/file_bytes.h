#pragma once

#include <string>

#include "core/base/result.h"

namespace alidade {

/// All bytes of a file of any kind, up to `limits::mostBytes`. The problem describes the error without the
/// file's name.
Result<std::string> readFile(const std::string& path);

/// All bytes of standard input.
Result<std::string> readStandardInput();

}  // namespace alidade
