#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/exchange/csv_table.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// The first rows of a table, without its remarks.
struct TableBeginning {
  std::vector<TableCells> head;          ///< rows before the readings, as many as there are to be
  std::vector<TableCells> sample;        ///< what follows, up to 200 rows
  std::size_t nameLine = 0;              ///< of the last row of `head`
  std::vector<std::size_t> nameColumns;  ///< where its cells begin, as in `CsvCell`
  std::optional<LineProblem> problem;    ///< why not even these can be taken apart
};

TableBeginning beginningOfTable(std::string_view text, char separator, std::size_t headRows);

/// `separator` 0: as the first row has it.
CsvTable tableOf(std::string_view text, char separator);

}  // namespace alidade
