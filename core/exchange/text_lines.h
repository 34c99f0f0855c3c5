#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace alidade {

/// One line of a file, without its end.
struct TextLine {
  std::size_t number = 0;  ///< from 1
  std::string_view text;
};

/// Lines parted by LF, CR LF or CR. The views live as long as `text`.
std::vector<TextLine> linesOf(std::string_view text);

/// How many characters `text` has; what tells a column from a byte.
std::size_t characterCount(std::string_view text);

/// The text of a file as UTF-8, without a byte order mark. Bytes that are no UTF-8 are taken for
/// Windows-1252, in which spreadsheets write ° and primes. Fails on UTF-16 and on what is no text (NUL
/// bytes).
Result<std::string> utf8Text(std::string_view bytes);

}  // namespace alidade
