#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/exchange/recording.h"

namespace alidade {

struct CsvCell {
  std::string text;        ///< unquoted, without blanks around
  std::size_t column = 0;  ///< of its first character in the line, from 1
};

struct CsvRow {
  std::size_t line = 0;  ///< its first, from 1
  std::vector<CsvCell> cells;
};

struct CsvTable {
  std::vector<CsvRow> rows;
  std::vector<CsvRow> remarks;  ///< lines that begin with #, taken apart without it
};

/// Takes a table apart (RFC 4180): cells are parted by tabs, semicolons or commas, whichever of these stands
/// in the first row (in this order); a cell that begins with a double quote ends at the next single one and
/// may hold anything, a quote inside doubled. Quotes elsewhere are the seconds of angles and stay. Rows
/// without any content are left out; lines that begin with # (and are not a first column of that name) are
/// remarks. Fails on a quote left open, but in a remark.
std::variant<CsvTable, LineProblem> parseCsv(std::string_view text);

}  // namespace alidade
