#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/exchange/column_name.h"
#include "core/exchange/recording.h"
#include "core/exchange/table_column.h"

namespace alidade {

enum class DecimalSign { Either, Point, Comma };

/// Separator of columns by two or more blanks, or by a tab: single blanks belong to cells, as in `107 12 23`.
inline constexpr char wideBlanks = '\v';

/// The layout of a table of readings. Default: one row of names; the file determines everything else.
struct TableLayout {
  char separator =
      '\0';  ///< tab, ; , |, a blank for any number of them, `wideBlanks`; 0: determined from the first row
  std::size_t headRows = 1;  ///< rows before the first reading; the last of them names the columns
  /// The content of each column: the key of a row's field, "axis", "turn", "station", "distance", or empty
  /// for an unused column. An angle in several columns has "horizontal", "horizontal_minutes" and
  /// "horizontal_seconds"; the second face in the same row has "horizontal_2" … (table_column.h). Empty list:
  /// the names determine the content.
  std::vector<std::string> columns = {};
  AngleUnit unit = AngleUnit::Unstated;           ///< unit of plain numbers in columns that name none
  DecimalSign decimalSign = DecimalSign::Either;  ///< decimal sign of angles
  bool needsVertical = true;  ///< false: also reads tables of directions alone, with empty vertical readings
  bool needsCircles = true;   ///< false: also accepts columns without a circle, as in pasted rows
  bool seriesIsStation = false;  ///< if there are rounds, a column `series` distinguishes stations

  bool operator==(const TableLayout&) const = default;
};

}  // namespace alidade
