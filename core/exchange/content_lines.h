#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace alidade {

/// The first non-empty lines of a text, at most `most`, with their blanks. Blank lines and comments of
/// programs, which begin with # @ ? % or !, are skipped. The views live as long as `text`.
std::vector<std::string_view> contentLines(std::string_view text, std::size_t most = 20);

/// A line without leading blanks, tabs and start-of-transmission marks (STX).
std::string_view withoutIndent(std::string_view line);

/// The parts between the separators, unchanged; at least one.
std::vector<std::string_view> separatedParts(std::string_view line, char separator);

}  // namespace alidade
