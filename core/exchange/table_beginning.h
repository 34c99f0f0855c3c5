#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/exchange/csv_table.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// The first rows of a table, without its comments.
struct TableBeginning {
  std::vector<TableCells> head;          ///< rows before the readings, at most as many as the layout states
  std::vector<TableCells> sample;        ///< following rows, up to 200
  std::size_t nameLine = 0;              ///< line of the last row of `head`
  std::vector<std::size_t> nameColumns;  ///< columns of the cells of that row, as in `CsvCell`
  std::optional<LineProblem> problem;    ///< why these rows cannot be split
};

TableBeginning beginningOfTable(std::string_view text, char separator, std::size_t headRows);

/// The table with this separator of cells; 0: determined from the first row.
CsvTable tableOf(std::string_view text, char separator);

}  // namespace alidade
