#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/table_layout.h"

namespace alidade {

/// The cells of one row of a table.
using TableCells = std::vector<std::string>;

/// The columns that make up one angle of a row.
struct PlannedAngle {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  const RowField* field = nullptr;
  bool isFaceTwo = false;                           ///< the angle belongs to the row's second sighting
  std::array<std::size_t, 3> at{none, none, none};  ///< columns of the degrees or the whole angle, of the
                                                    ///< minutes and of the seconds
  AngleUnit unit = AngleUnit::Unstated;             ///< unit of plain numbers, if the angle has one column
  bool isCentesimal = false;                        ///< hundredths of gon in columns of their own

  bool isJoined() const { return at[1] != none; }
};

/// The columns of a table, identified by their headings, which may have several rows, and by the numbers
/// below them.
struct TablePlan {
  std::vector<TableCells> headings;  ///< rows above the names, the names, rows of units or parts below
  TableCells names;                  ///< a text for each column, for sentences
  std::vector<ColumnName> columns;
  std::vector<PlannedAngle> angles;
  std::size_t rowsBelow = 0;   ///< rows of the sample that belong to the headings
  bool hasBothFaces = false;   ///< each row has columns for both faces
  int face = 0;                ///< face of all sightings, if the headings state it; else 0
  std::string verticalCircle;  ///< "zenith", "elevation", or empty
  /// The reason why the table cannot be read; `problemColumn` counts from 0.
  std::optional<std::string> problem;
  std::size_t problemColumn = 0;

  std::string nameOf(std::size_t column) const;  ///< the name in quotes, or the column's number
};

/// Plans a table. `head`: the rows before the readings, of which the last names the columns; `sample`: rows
/// that follow.
TablePlan planTable(const std::vector<TableCells>& head, const std::vector<TableCells>& sample,
                    const TableLayout& layout);

/// Do both rows name columns, the upper one circles, and the lower one more than units, parts and faces?
bool isHeadingAboveNames(const TableCells& above, const TableCells& below);

/// Is this a row below names with units, parts of angles or faces: `;[gon];[gon]`, `;deg;min;sec`?
bool isRowBelowNames(const TableCells& cells);

}  // namespace alidade
