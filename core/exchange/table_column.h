#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/session/row_fields.h"

namespace alidade {

/// The part of an angle that a column holds.
enum class AnglePart {
  Degrees,  ///< the whole angle, or its degrees (gon) if other columns hold the rest
  Minutes,
  Seconds,
};

/// The content of a table's column: a field of a row, or data about the row.
struct TableColumn {
  enum class Other {
    Axis,      ///< the axis angle
    Turn,      ///< the repeat at that axis
    Station,   ///< the instrument's station, which a session does not use
    Distance,  ///< distance to the target, in m unless stated otherwise; not used in a session
  };
  const RowField* field = nullptr;  ///< null: see `other`
  Other other = Other::Axis;
  AnglePart part = AnglePart::Degrees;  ///< part of an angle
  bool isFaceTwo = false;               ///< a reading of face 2, where a row has columns for both faces

  /// The key as in `TableLayout::columns`: `horizontal`, `horizontal_minutes`, `vertical_2_seconds`.
  std::string key() const;
  /// Does a session have this content?
  bool isOfSession() const { return field || other == Other::Axis || other == Other::Turn; }
  bool isOf(std::string Reading::*text) const { return field && field->text == text; }
  /// Is the content a reading of one of the two circles?
  bool isCircle() const { return field && field->remedy; }

  static constexpr std::array<std::string_view, 4> otherKeys{"axis", "turn", "station", "distance"};
  bool operator==(const TableColumn&) const = default;
};

/// The column with this key; absent if there is none.
std::optional<TableColumn> tableColumn(std::string_view key);

}  // namespace alidade
