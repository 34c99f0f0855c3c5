#include "core/base/list_text.h"

namespace alidade {

std::string listed(const std::vector<std::string>& entries, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0) text += i + 1 == entries.size() ? last : ", ";
    text += entries[i];
  }
  return text;
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace alidade
