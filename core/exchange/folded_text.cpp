#include "core/exchange/words.h"

#include <algorithm>
#include <iterator>

#include "core/base/typed_text.h"
#include "core/base/utf8.h"

namespace alidade {

namespace {

bool isWithin(char32_t code, char32_t first, char32_t last) {
  return code >= first && code <= last;
}

/// U+00C0 … U+017F without accents and in lower case, one byte each; a blank keeps the letter as it is.
constexpr std::string_view plainLatin =
    "aaaaaa ceeeeiiii nooooo ouuuuy  aaaaaa ceeeeiiii nooooo ouuuuy y"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiii  jjkk llllll "
    " llnnnnnn nnoooooo  rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzz ";
static_assert(plainLatin.size() == 0x180 - 0xC0);

/// Removes the mark above a Cyrillic letter.
char32_t plainCyrillic(char32_t code) {
  if (code == U'\u0451') return U'\u0435';      // ё
  return code == U'\u0439' ? U'\u0438' : code;  // й
}

/// Lower case of Greek and Cyrillic letters.
char32_t smallLetter(char32_t code) {
  constexpr char32_t toSmall = 0x20, toSmallOfExtension = 0x50;
  if (isWithin(code, U'\u0391', U'\u03A9') || isWithin(code, U'\u0410', U'\u042F')) return code + toSmall;
  return isWithin(code, U'\u0400', U'\u040F') ? code + toSmallOfExtension : code;
}

/// Appends a letter of two UTF-8 bytes, as Greek and Cyrillic letters have.
void appendLetter(std::string& text, char32_t code) {
  text += static_cast<char>(0xC0 | (code >> 6));
  text += static_cast<char>(0x80 | (code & 0x3F));
}

void appendFolded(std::string& folded, std::string_view character, char32_t code) {
  const bool isCombining = isWithin(code, U'\u0300', U'\u036F');
  const bool isLatin = isWithin(code, U'\u00C0', U'\u017F') && plainLatin[code - 0xC0] != ' ';
  if (isCombining) return;
  if (code < 0x80)
    folded += code >= 'A' && code <= 'Z' ? static_cast<char>(code - 'A' + 'a') : static_cast<char>(code);
  else if (code == U'\u00DF')
    folded += "ss";
  else if (code == U'\u2116')
    folded += "no";
  else if (isLatin)
    folded += plainLatin[code - 0xC0];
  else if (isWithin(code, U'\u0391', U'\u045F'))
    appendLetter(folded, plainCyrillic(smallLetter(code)));
  else
    folded += character;
}

}  // namespace

std::string foldedText(std::string_view text) {
  const std::string plain = plainSigns(text);
  std::string_view rest = plain;
  std::string folded;
  while (!rest.empty()) {
    const Utf8Character character = firstCharacter(rest);
    appendFolded(folded, rest.substr(0, character.length), character.code);
    rest.remove_prefix(character.length);
  }
  return folded;
}

}  // namespace alidade
