#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace alidade {

/// The first lines of a text that hold something, at most `most`, with their blanks: lines of blanks, and
/// comments of programs that begin with # @ ? % or !, are left out. The views live as long as `text`.
std::vector<std::string_view> contentLines(std::string_view text, std::size_t most = 20);

/// A line without blanks, tabs and the mark of a transmission (STX) before its first sign.
std::string_view withoutIndent(std::string_view line);

/// The parts between the separators, as they stand; at least one.
std::vector<std::string_view> separatedParts(std::string_view line, char separator);

}  // namespace alidade
