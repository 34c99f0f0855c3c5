#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// Rows of a table, as copied from a spreadsheet, whose columns are fields.
struct JoinedTable {
  std::vector<TableColumn> columns;  ///< whole angles each; both faces of a row are rows of their own
  std::vector<std::string> names;    ///< of these, as they are written
  std::vector<TableCells> rows;      ///< a cell for each column; plain numbers have the unit of their heading
  std::vector<std::string> unplaced;  ///< headings of columns that are none of these
};

/// The rows below one or more rows of headings (table_plan.h), with degrees, minutes and seconds joined;
/// parts that make no angle stay side by side, for who reads on to refuse. Absent where the first row names
/// no columns; fails where the headings cannot be taken, as those of two columns for one field.
std::optional<Result<JoinedTable>> joinedTable(const std::vector<TableCells>& rows);

}  // namespace alidade
