#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace alidade {

/// The first character of a text. An ill-formed byte counts as one character, U+FFFD.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< bytes; 0 only if the text is empty
  bool wellFormed = true;
};

Utf8Character firstCharacter(std::string_view text);

/// The offset of the first byte that is not UTF-8; empty if all are valid.
std::optional<std::size_t> firstIllFormedByte(std::string_view text);

}  // namespace alidade
