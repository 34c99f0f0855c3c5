#include "core/base/list_text.h"

#include "core/base/phrase.h"

namespace alidade {

std::string listed(const std::vector<std::string>& entries) {
  return listed(entries, Phrase::of(", "));
}

std::string listed(const std::vector<std::string>& entries, std::string_view last) {
  //: between the entries of a list
  const std::string comma = Phrase::of(", ");
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0) text += i + 1 == entries.size() ? last : std::string_view(comma);
    text += entries[i];
  }
  return text;
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace alidade
