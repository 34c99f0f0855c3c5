#include "core/base/given_arguments.h"

#include <string_view>

#include "core/base/visible_text.h"

namespace alidade {

std::optional<std::string> emptyArgument(int count, const char* const* arguments) {
  constexpr std::string_view remedy = "give a value, or leave the option out";
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i], before = i > 1 ? arguments[i - 1] : "";
    if (argument.starts_with("--") && argument.find('=') == argument.size() - 1)
      return visibleText(std::string(argument.substr(0, argument.size() - 1))) +
             " is given an empty value: " + std::string(remedy);
    if (!argument.empty()) continue;
    if (before.starts_with("--") && before.find('=') == std::string_view::npos && before.size() > 2)
      return visibleText(std::string(before)) + " is given an empty value: " + std::string(remedy);
    return "argument " + std::to_string(i) + " is empty: name a file, or leave it out";
  }
  return std::nullopt;
}

}  // namespace alidade
