#include "core/exchange/content_lines.h"

#include <algorithm>

#include "core/exchange/text_lines.h"

namespace alidade {

std::string_view withoutIndent(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\x02"), line.size()));
  return line;
}

std::vector<std::string_view> contentLines(std::string_view text, std::size_t most) {
  std::vector<std::string_view> found;
  TextLines lines(text);
  while (found.size() < most) {
    const auto line = lines.next();
    if (!line) break;
    const std::string_view content = withoutIndent(line->text);
    if (!content.empty() && std::string_view("#@?%!").find(content[0]) == std::string_view::npos)
      found.push_back(line->text);
  }
  return found;
}

std::vector<std::string_view> separatedParts(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::string_view part = line.substr(0, line.find(separator));
    parts.push_back(part);
    if (part.size() == line.size()) return parts;
    line.remove_prefix(part.size() + 1);
  }
}

}  // namespace alidade
