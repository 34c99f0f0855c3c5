#include "core/certificate/stated.h"

#include <array>
#include <string_view>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/certificate/element.h"

namespace alidade {

std::string listedNouns(const StatedEntries& stated) {
  std::vector<std::string> nouns;
  for (const char* noun : stated.notStated) nouns.push_back(Phrase::of(noun));
  return listed(nouns);
}

std::pair<std::string, std::string> nameAndAddress(const std::string& text) {
  constexpr std::array<std::string_view, 5> separators = {",", ";", "\n", "，", "；"};
  std::size_t at = std::string::npos, length = 0;
  for (const std::string_view separator : separators)
    if (const std::size_t found = text.find(separator); found < at) {
      at = found;
      length = separator.size();
    }
  if (at == std::string::npos) return {text, {}};
  std::string name = certificateText(text.substr(0, at)), address = certificateText(text.substr(at + length));
  if (name.empty()) return nameAndAddress(address);
  return {std::move(name), std::move(address)};
}

}  // namespace alidade
