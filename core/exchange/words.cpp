#include "core/exchange/words.h"

#include <algorithm>
#include <iterator>

#include "core/base/phrase.h"
#include "core/exchange/text_lines.h"

namespace alidade {

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string upperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::string plainKey(std::string_view key) {
  static constexpr const char* keys[] = {
      PHRASE_LATER("Phrase", "axis"),       PHRASE_LATER("Phrase", "point"),
      PHRASE_LATER("Phrase", "round"),      PHRASE_LATER("Phrase", "face"),
      PHRASE_LATER("Phrase", "horizontal"), PHRASE_LATER("Phrase", "vertical"),
      PHRASE_LATER("Phrase", "slider"),     PHRASE_LATER("Phrase", "excluded"),
      PHRASE_LATER("Phrase", "note"),       PHRASE_LATER("Phrase", "zenith"),
      PHRASE_LATER("Phrase", "elevation"),
  };
  const auto* const known = std::find(std::begin(keys), std::end(keys), key);
  return known == std::end(keys) ? std::string(key) : Phrase::of(*known);
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool isSameName(std::string_view one, std::string_view other) {
  const auto plain = [](std::string_view name) {
    const bool isNumber = !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
    if (isNumber) name.remove_prefix(std::min(name.find_first_not_of('0'), name.size() - 1));
    return upperCase(std::string(name));
  };
  return plain(one) == plain(other);
}

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
