#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/recording.h"

namespace alidade {

enum class DecimalSign { Either, Point, Comma };

/// How a table of readings is to be taken. As made: one row of names, and the rest as it stands.
struct TableLayout {
  char separator = '\0';     ///< tab, ; , or a blank for any number of them; 0: as the first row has it
  std::size_t headRows = 1;  ///< rows before the first of readings; the last of them names the columns
  /// What each column holds: the key of a field of a row, "axis", "turn", "station", "distance", or nothing
  /// of use. Empty: as their names say.
  std::vector<std::string> columns = {};
  AngleUnit unit = AngleUnit::Unstated;           ///< of plain numbers in columns whose name has none
  DecimalSign decimalSign = DecimalSign::Either;  ///< of angles

  bool operator==(const TableLayout&) const = default;
};

/// What a column of a table holds: a field of a row, or what stands beside it.
struct TableColumn {
  enum class Beside {
    Axis,      ///< how the axis stood
    Turn,      ///< the how many-th position at it
    Station,   ///< where the instrument stood; of no use to a session
    Distance,  ///< to what was sighted, m where nothing else is said; likewise
  };
  const RowField* field = nullptr;  ///< null: what is `beside`
  Beside beside = Beside::Axis;

  std::string_view key() const { return field ? field->key : besideKeys[static_cast<std::size_t>(beside)]; }
  /// Has a session a place for it?
  bool isOfSession() const { return field || beside == Beside::Axis || beside == Beside::Turn; }

  static constexpr std::array<std::string_view, 4> besideKeys{"axis", "turn", "station", "distance"};
  bool operator==(const TableColumn&) const = default;
};

/// The column by its key; absent where there is none.
std::optional<TableColumn> tableColumn(std::string_view key);

/// What the name of a column says.
struct ColumnName {
  std::optional<TableColumn> column = {};
  AngleUnit unit = AngleUnit::Unstated;
  std::string verticalCircle = {};  ///< that the name speaks of; may be empty
  double metres = 1;                ///< to a unit of a distance
  bool isHorizontal = false;        ///< of a distance
};

/// Capitals, blanks, _ and words such as “angle”, “circle” and “reading” do not matter: `Hz [gon]`, `v_deg`.
ColumnName columnName(const std::string& text);

/// Do these cells name columns? One at least is known, and none holds a number.
bool areColumnNames(const std::vector<std::string>& cells);

}  // namespace alidade
