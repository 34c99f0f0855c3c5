#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// One line of a file, without its end.
struct TextLine {
  std::size_t number = 0;  ///< from 1
  std::string_view text;
};

/// Lines parted by LF, CR LF or CR, one after the other: a list of all would take many times the text of
/// short ones. ^Z (0x1A) ends them, as it ends a file of DOS. The views live as long as `text`.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : m_rest(text) {}

  std::optional<TextLine> next();
  /// The line of a ^Z that was come to; absent where there is none.
  std::optional<std::size_t> tailLine() const { return m_tailLine; }

 private:
  std::string_view m_rest;
  std::size_t m_number = 0;
  std::optional<std::size_t> m_tailLine;
};

/// How many characters `text` has; what tells a column from a byte.
std::size_t characterCount(std::string_view text);

/// The text of a file as UTF-8, without a byte order mark. Bytes that are neither UTF-8 nor UTF-16 are taken
/// for GB 18030 or Windows-1251, where they look so (text_encoding.h), else for Windows-1252, in which
/// spreadsheets write ° and primes. Control characters at the beginning of a line are left out, others
/// become blanks: instruments send STX, ETX and BEL, and fill lines with NUL. ^Z ends the text; it stays with
/// what comes behind it, unless this is nothing to tell of. Fails on what is no text, and where the text
/// comes to have more bytes than are read.
Result<std::string> utf8Text(std::string_view bytes);

}  // namespace alidade
