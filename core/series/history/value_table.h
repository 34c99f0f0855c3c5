#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/series/history/history.h"

namespace alidade {

/// Dated values of one quantity, as a file has them.
struct ValueTable {
  std::vector<DatedValue> values;    ///< in the order of the file
  std::string unit;                  ///< as the name of the column has it in brackets; may be empty
  std::vector<std::string> remarks;  ///< what was made of the file, where it could be meant otherwise
};

/// Reads a table of date, value and standard uncertainty: parted by tabs, semicolons, commas or blanks, with
/// a decimal point or comma, with names of columns or without. Without, the columns stand in this order
/// behind any that hold neither a date nor a number. A value may bring its uncertainty along, as 6.6743(15)
/// or 6.6743 ± 0.0015. A column named as an expanded uncertainty (k = 2) is halved, with a remark. Rows
/// without a value are left out, with a remark; a value without an uncertainty, or with one that is no
/// positive number, fails by its line. Years alone are the middle of the year, unless another date of the
/// column is a decimal year.
Result<ValueTable> readValueTable(std::string_view bytes);

}  // namespace alidade
