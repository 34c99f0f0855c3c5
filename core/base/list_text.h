#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// "a, b, c".
std::string listed(const std::vector<std::string>& entries);
/// `last` separates the last two entries: "a, b or c" with " or ".
std::string listed(const std::vector<std::string>& entries, std::string_view last);

/// "1 row", "2 rows": for a noun whose plural ends in s.
std::string counted(std::size_t count, std::string_view noun);

}  // namespace alidade
