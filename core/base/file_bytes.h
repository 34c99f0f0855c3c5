#pragma once

#include <string>

#include "core/base/result.h"

namespace alidade {

/// All bytes of a file of at most 512 MiB, whatever kind of file it is. The sentence names the file's
/// trouble, not the file.
Result<std::string> readFile(const std::string& path);

}  // namespace alidade
