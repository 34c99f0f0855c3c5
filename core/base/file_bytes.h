#pragma once

#include <string>

#include "core/base/result.h"

namespace alidade {

/// All bytes of a file, whatever kind of file it is, up to `limits::mostBytes`. The sentence names the file's
/// trouble, not the file.
Result<std::string> readFile(const std::string& path);

/// The same of standard input.
Result<std::string> readStandardInput();

}  // namespace alidade
