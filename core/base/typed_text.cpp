#include "core/base/typed_text.h"

#include "core/base/utf8.h"

namespace alidade {

namespace {

/// The plain sign for a character; null where the character stands for itself.
const char* plainSign(char32_t code) {
  switch (code) {
    case U'\u2212':  // minus sign
      return "-";
    case U'\u2032':  // prime
    case U'\u2019':  // right single quotation mark
      return "'";
    case U'\u2033':  // double prime
    case U'\u201D':  // right double quotation mark
      return "\"";
    case U'\u00BA':  // masculine ordinal indicator
    case U'\u02DA':  // ring above
      return "°";
    case U'\t':
    case U'\u00A0':  // no-break space
    case U'\u2007':  // figure space
    case U'\u2009':  // thin space
    case U'\u202F':  // narrow no-break space
      return " ";
    default:
      return nullptr;
  }
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
    if (const char* sign = plainSign(character.code)) {
      plain += sign;
    } else {
      plain += typed.substr(0, character.length);
    }
    typed.remove_prefix(character.length);
  }
  return trimmed(plain);
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace alidade
