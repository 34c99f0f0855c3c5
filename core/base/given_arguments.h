#pragma once

#include <optional>
#include <string>

namespace alidade {

/// Returns the reason if the arguments of a program are invalid: one is empty, or an option is given as
/// `--option=`, for example from an unset variable of a script. Absent if all are valid.
std::optional<std::string> emptyArgument(int count, const char* const* arguments);

}  // namespace alidade
