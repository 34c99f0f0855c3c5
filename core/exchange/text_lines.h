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
/// short ones. The views live as long as `text`.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : m_rest(text) {}

  std::optional<TextLine> next();

 private:
  std::string_view m_rest;
  std::size_t m_number = 0;
};

/// How many characters `text` has; what tells a column from a byte.
std::size_t characterCount(std::string_view text);

/// The text of a file as UTF-8, without a byte order mark. Bytes that are no UTF-8 are taken for
/// Windows-1252, in which spreadsheets write ° and primes. Fails on UTF-16, on what is no text (NUL bytes),
/// and where the text comes to have more bytes than are read.
Result<std::string> utf8Text(std::string_view bytes);

}  // namespace alidade
