#include "core/exchange/table_beginning.h"

namespace alidade {

TableBeginning beginningOfTable(std::string_view text, char separator, std::size_t headRows) {
  constexpr std::size_t mostRows = 200;
  TableBeginning beginning;
  CsvTable table = tableOf(text, separator);
  while (beginning.sample.size() < mostRows) {
    const auto row = table.next();
    if (!row) break;
    if (row->isRemark) continue;
    const bool isHead = beginning.head.size() < headRows;
    if (isHead) {
      beginning.nameLine = row->line;
      beginning.nameColumns.clear();
      for (const CsvCell& cell : row->cells) beginning.nameColumns.push_back(cell.column);
    }
    (isHead ? beginning.head : beginning.sample).push_back(row->texts());
  }
  beginning.problem = table.problem();
  return beginning;
}

CsvTable tableOf(std::string_view text, char separator) {
  return separator ? CsvTable(text, separator) : CsvTable(text);
}

}  // namespace alidade
