#include "core/base/typed_text.h"

#include <algorithm>

#include "core/base/utf8.h"

namespace alidade {

namespace {

/// The plain sign for a character; empty if the character stays.
std::string_view plainSign(char32_t code) {
  switch (code) {
    case U'\u2212':  // minus sign
    case U'\u2013':  // en dash
    case U'\uFE63':  // small hyphen-minus
      return "-";
    case U'\u00B4':  // acute accent
    case U'`':
    case U'\u02B9':  // modifier letter prime
    case U'\u02BC':  // modifier letter apostrophe
    case U'\u2018':  // left single quotation mark
    case U'\u2019':  // right single quotation mark
    case U'\u201B':  // reversed single quotation mark
    case U'\u2032':  // prime
    case U'\u2035':  // reversed prime
      return "'";
    case U'\u02BA':  // modifier letter double prime
    case U'\u02DD':  // double acute accent
    case U'\u201C':  // left double quotation mark
    case U'\u201D':  // right double quotation mark
    case U'\u201F':  // reversed double quotation mark
    case U'\u2033':  // double prime
    case U'\u2036':  // reversed double prime
      return "\"";
    case U'\u00BA':  // masculine ordinal indicator
    case U'\u02DA':  // ring above
    case U'\u2070':  // superscript zero
    case U'\u2218':  // ring operator
    case U'\u25E6':  // white bullet
      return "°";
    case U'\t':
    case U'\u00A0':  // no-break space
    case U'\u202F':  // narrow no-break space
    case U'\u205F':  // medium mathematical space
    case U'\u3000':  // ideographic space
      return " ";
    default:
      return code >= U'\u2000' && code <= U'\u200A' ? " " : "";  // from en quad to hair space
  }
}

/// The ASCII form of a fullwidth character of an input method: 0 for ０, : for ：; '\0' for other characters.
char asciiOf(char32_t code) {
  constexpr char32_t first = U'\uFF01', last = U'\uFF5E';
  return code >= first && code <= last ? static_cast<char>(code - first + U'!') : '\0';
}

void appendPlain(std::string& plain, std::string_view character, char32_t code) {
  const char ascii = asciiOf(code);
  const std::string_view sign = plainSign(ascii ? static_cast<char32_t>(ascii) : code);
  if (!sign.empty())
    plain += sign;
  else if (ascii)
    plain += ascii;
  else
    plain += character;
}

/// Is this a decimal digit of another script, such as Arabic? The ten digits of a script are consecutive.
bool isForeignDigit(char32_t code) {
  constexpr char32_t zeros[] = {U'\u0660', U'\u06F0', U'\u07C0', U'\u0966', U'\u09E6', U'\u0A66',
                                U'\u0AE6', U'\u0B66', U'\u0BE6', U'\u0C66', U'\u0CE6', U'\u0D66',
                                U'\u0E50', U'\u0ED0', U'\u0F20', U'\u1040', U'\u17E0', U'\u1810'};
  return std::ranges::any_of(zeros, [code](char32_t zero) { return code >= zero && code < zero + 10; });
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::string plainSigns(std::string_view typed) {
  std::string plain;
  plain.reserve(typed.size());
  while (!typed.empty()) {
    const Utf8Character character = firstCharacter(typed);
    appendPlain(plain, typed.substr(0, character.length), character.code);
    typed.remove_prefix(character.length);
  }
  return trimmed(plain);
}

bool hasForeignDigits(std::string_view text) {
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    if (isForeignDigit(character.code)) return true;
    text.remove_prefix(character.length);
  }
  return false;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace alidade
