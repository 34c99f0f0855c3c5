#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/exchange/column_name.h"
#include "core/exchange/recording.h"
#include "core/exchange/table_column.h"

namespace alidade {

enum class DecimalSign { Either, Point, Comma };

/// The separator of a table whose columns stand apart by two blanks and more, or by a tab: single blanks are
/// within cells, as in `107 12 23`.
inline constexpr char wideBlanks = '\v';

/// How a table of readings is to be taken. As made: one row of names, and the rest as it stands.
struct TableLayout {
  char separator =
      '\0';  ///< tab, ; , |, a blank for any number of them, `wideBlanks`; 0: as the first row has it
  std::size_t headRows = 1;  ///< rows before the first of readings; the last of them names the columns
  /// What each column holds: the key of a field of a row, "axis", "turn", "station", "distance", or nothing
  /// of use. Of an angle in several columns "horizontal", "horizontal_minutes" and "horizontal_seconds", of
  /// the second face in the same row "horizontal_2" … (table_column.h). Empty: as their names say.
  std::vector<std::string> columns = {};
  AngleUnit unit = AngleUnit::Unstated;           ///< of plain numbers in columns whose name has none
  DecimalSign decimalSign = DecimalSign::Either;  ///< of angles
  bool needsVertical = true;  ///< false: a table of directions alone is read, its vertical readings empty
  bool needsCircles = true;   ///< false: columns without any circle are taken, too; of rows that are pasted
  bool seriesIsStation = false;  ///< a column `series` tells stations apart where there are rounds besides

  bool operator==(const TableLayout&) const = default;
};

}  // namespace alidade
