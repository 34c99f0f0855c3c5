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

/// Which columns make up one angle of a row.
struct PlannedAngle {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  const RowField* field = nullptr;
  bool isFaceTwo = false;                           ///< of the second sighting in the row
  std::array<std::size_t, 3> at{none, none, none};  ///< of the degrees or all of it, the minutes, the seconds
  AngleUnit unit = AngleUnit::Unstated;             ///< of plain numbers where it stands in one column
  bool isCentesimal = false;                        ///< hundredths of gon in columns of their own

  bool isJoined() const { return at[1] != none; }
};

/// What the columns of a table hold: found by their headings, which may stand in several rows, and by the
/// numbers below them.
struct TablePlan {
  std::vector<TableCells> headings;  ///< those rows that name: above, the names, units or parts below
  TableCells names;                  ///< for sentences, a text for each column
  std::vector<ColumnName> columns;
  std::vector<PlannedAngle> angles;
  std::size_t rowsBelow = 0;   ///< of the sample, that belong to the headings
  bool hasBothFaces = false;   ///< in one row
  int face = 0;                ///< of all sightings, where the headings tell it
  std::string verticalCircle;  ///< "zenith", "elevation", or empty
  /// Why the table cannot be read, and of which column, from 0.
  std::optional<std::string> problem;
  std::size_t problemColumn = 0;

  std::string nameOf(std::size_t column) const;  ///< quoted, or its number
};

/// `head`: the rows before the readings, of which the last names the columns; `sample`: rows that follow.
TablePlan planTable(const std::vector<TableCells>& head, const std::vector<TableCells>& sample,
                    const TableLayout& layout);

/// Do both rows name columns, the upper one the circles, and the lower one more than units, parts and faces?
bool standsAboveNames(const TableCells& above, const TableCells& below);

/// Does the row stand below names, and tell units, parts of angles or faces: `;[gon];[gon]`, `;deg;min;sec`?
bool isRowBelowNames(const TableCells& cells);

}  // namespace alidade
