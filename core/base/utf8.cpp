#include "core/base/utf8.h"

#include <boost/locale/utf.hpp>

namespace alidade {

namespace utf = boost::locale::utf;

Utf8Character firstCharacter(std::string_view text) {
  constexpr char32_t replacement = 0xFFFD;
  if (text.empty()) return {};
  const char* at = text.data();
  const utf::code_point code = utf::utf_traits<char>::decode(at, text.data() + text.size());
  if (!utf::is_valid_codepoint(code)) return {replacement, 1, false};
  return {code, static_cast<std::size_t>(at - text.data()), true};
}

std::optional<std::size_t> firstIllFormedByte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Utf8Character character = firstCharacter(text.substr(at));
    if (!character.wellFormed) return at;
    at += character.length;
  }
  return std::nullopt;
}

}  // namespace alidade
