#pragma once

#include <string>
#include <vector>

#include "core/exchange/table_plan.h"

namespace alidade {

/// Combines the heading rows of a table into one. Text above several columns precedes each of their names;
/// units and parts below follow the name. `Horizontal` over `deg`, `min`, `sec` becomes `Horizontal deg`,
/// `Horizontal min`, ….
class TableHeadings {
 public:
  /// Arguments as in `planTable`.
  TableHeadings(const std::vector<TableCells>& head, const std::vector<TableCells>& sample);

  std::size_t rowsBelow() const { return m_rowsBelow; }
  const std::vector<TableCells>& rows() const { return m_levels; }
  /// The name of the column in the file, for sentences.
  std::string writtenName(std::size_t column) const;
  /// The meaning of the heading, with all rows combined.
  ColumnName nameOf(std::size_t column) const;
  std::size_t width() const { return m_width; }
  /// Are all heading rows empty in this column?
  bool isBlank(std::size_t column) const;

 private:
  struct Run {
    std::size_t first = 0, count = 0;
  };

  void findLevels(const std::vector<TableCells>& head, const std::vector<TableCells>& sample);
  void findRuns();
  std::string cell(std::size_t level, std::size_t column) const;
  std::string lowest(std::size_t column, std::size_t from) const;
  std::string spanned(std::size_t level, std::size_t column) const;
  bool mayInherit(std::size_t column, std::size_t from) const;

  std::vector<TableCells> m_levels;
  std::vector<Run> m_runs;  ///< adjacent columns of degrees, minutes, seconds that name no circle
  bool m_hasUpper = false;
  std::size_t m_rowsBelow = 0, m_width = 0;
};

}  // namespace alidade
