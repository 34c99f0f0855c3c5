#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// Rows of a table, as copied from a spreadsheet, with a field for each column.
struct JoinedTable {
  std::vector<TableColumn> columns;  ///< angles are whole; each face has a row of its own
  std::vector<std::string> names;    ///< names of `columns`, as written
  std::vector<TableCells> rows;      ///< a cell for each column; plain numbers have the unit of their heading
  std::vector<std::string> unplaced;  ///< headings of columns without a field
};

/// The rows below one or more heading rows (table_plan.h), with degrees, minutes and seconds joined; parts
/// that form no angle stay as text, for the reader to refuse. Absent if the first row names no columns or no
/// row follows; fails if the headings conflict, such as two columns for one field.
std::optional<Result<JoinedTable>> joinedTable(const std::vector<TableCells>& rows);

}  // namespace alidade
