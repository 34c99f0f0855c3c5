#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/session/row_fields.h"

namespace alidade {

/// What a column holds of an angle.
enum class AnglePart {
  Degrees,  ///< the whole angle, or its degrees (gon) where other columns hold the rest
  Minutes,
  Seconds,
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
  AnglePart part = AnglePart::Degrees;  ///< of an angle
  bool isFaceTwo = false;  ///< of a circle whose other face stands in the same row, in columns of its own

  /// As in `TableLayout::columns`: `horizontal`, `horizontal_minutes`, `vertical_2`, `vertical_2_seconds`.
  std::string key() const;
  /// Has a session a place for it?
  bool isOfSession() const { return field || beside == Beside::Axis || beside == Beside::Turn; }
  bool isOf(std::string Reading::*text) const { return field && field->text == text; }
  /// One of the two circles.
  bool isCircle() const { return field && field->remedy; }

  static constexpr std::array<std::string_view, 4> besideKeys{"axis", "turn", "station", "distance"};
  bool operator==(const TableColumn&) const = default;
};

/// The column by its key; absent where there is none.
std::optional<TableColumn> tableColumn(std::string_view key);

}  // namespace alidade
