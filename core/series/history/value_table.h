#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/series/history/history.h"

namespace alidade {

/// Dated values of one quantity, as in a file.
struct ValueTable {
  std::vector<DatedValue> values;    ///< in the order of the file
  std::string unit;                  ///< from the brackets in the column's name; may be empty
  std::vector<std::string> remarks;  ///< how ambiguous content was interpreted
};

/// Reads a table of date, value and standard uncertainty: separated by tabs, semicolons, commas or blanks,
/// with a decimal point or comma, with or without column names. Columns whose names mean a date, a value or
/// an uncertainty are taken; without such names, the columns are in this order, and those that hold neither a
/// date nor a number are skipped. Fails if several columns could be the value or u, or if both state a unit,
/// and not the same. A value may include its uncertainty, as 6.6743(15) or 6.6743 ± 0.0015. A column named as
/// an expanded uncertainty (k = 2) is halved, with a remark. Rows without a value are skipped, with a remark.
/// Fails, with the line, if a value lacks a positive u. A year alone means the middle of the year, or the
/// beginning if another date is a decimal year.
Result<ValueTable> readValueTable(std::string_view bytes);

}  // namespace alidade
