#include "core/base/utf8.h"

#include <array>

namespace alidade {

namespace {

constexpr char32_t replacementCharacter = 0xFFFD;

std::size_t lengthByLead(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

bool isOverlongOrOutside(char32_t code, std::size_t length) {
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < smallest[length] || surrogate || code > 0x10FFFF;
}

}  // namespace

Utf8Character firstCharacter(std::string_view text) {
  if (text.empty()) return {};
  constexpr Utf8Character illFormed = {replacementCharacter, 1, false};
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lengthByLead(lead);
  if (length == 1) return {lead, 1, true};
  if (length == 0 || text.size() < length) return illFormed;

  char32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0u) != 0x80u) return illFormed;
    code = (code << 6) | (byte & 0x3Fu);
  }
  if (isOverlongOrOutside(code, length)) return illFormed;
  return {code, length, true};
}

std::optional<std::size_t> firstIllFormedByte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    if (static_cast<unsigned char>(text[at]) < 0x80) {
      ++at;
      continue;
    }
    const Utf8Character character = firstCharacter(text.substr(at));
    if (!character.wellFormed) return at;
    at += character.length;
  }
  return std::nullopt;
}

}  // namespace alidade
