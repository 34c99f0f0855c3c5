#pragma once

#include <optional>
#include <string>

namespace alidade {

/// Why the arguments of a program cannot be taken: one of them is empty, or an option is given as
/// `--option=`, as where a script's variable is not set. Absent where every one says something.
std::optional<std::string> emptyArgument(int count, const char* const* arguments);

}  // namespace alidade
