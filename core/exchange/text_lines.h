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

/// The lines of a text, separated by LF, CR LF or CR, one at a time: a list of many short lines would take
/// many times the memory of the text. ^Z (0x1A) ends the text, as in a DOS file. The views live as long as
/// `text`.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : m_rest(text) {}

  std::optional<TextLine> next();
  /// The line of the ^Z that was reached; absent if there is none.
  std::optional<std::size_t> tailLine() const { return m_tailLine; }

 private:
  std::string_view m_rest;
  std::size_t m_number = 0;
  std::optional<std::size_t> m_tailLine;
};

/// The text before ^Z; the whole text if it has none.
std::string_view untilEndOfFile(std::string_view text);

/// The number of characters in `text`; converts bytes to columns.
std::size_t characterCount(std::string_view text);

/// The text of a file as UTF-8, without a byte order mark. Bytes that are neither UTF-8 nor UTF-16 are read
/// as GB 18030 or Windows-1251 if they look Chinese or Cyrillic (text_encoding.h), else as Windows-1252, in
/// which spreadsheets write ° and primes. Control characters at the beginning of a line are removed;
/// others become blanks: instruments send STX, ETX and BEL, and pad lines with NUL. ^Z ends the text and
/// stays only if content worth reporting follows. Fails if the bytes are not text or exceed the size limit.
Result<std::string> utf8Text(std::string_view bytes);

}  // namespace alidade
