#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/recording.h"
#include "core/exchange/table_column.h"

namespace alidade {

/// What the heading of a column says.
struct ColumnName {
  std::optional<TableColumn> column = {};
  AngleUnit unit = AngleUnit::Unstated;
  std::string verticalCircle = {};  ///< that the name speaks of; may be empty
  double metres = 1;                ///< to a unit of a distance
  bool isHorizontal = false;        ///< of a distance
  bool isPart = false;  ///< names degrees, minutes or seconds: of `column`, or of the heading beside or above
  AnglePart part = AnglePart::Degrees;
  bool isCentesimal = false;  ///< its minutes and seconds are hundredths
  bool isGrad = false;        ///< the unit is called grad, which is degrees in German and gon in French
  int face = 0;               ///< 1 or 2, where the name tells it
  bool isWeak = false;        ///< means the column only where no other names it: `H`, `No`
  bool isSpanish = false;     ///< of a face: D and I are directo and inverso
  bool isUnderstood = false;  ///< no word of it is unknown, and there is one
};

/// Case, accents, blanks, _ and words such as “angle”, “circle” and “reading” do not matter: `Hz [gon]`,
/// `v_deg`, `Horizontalwinkel`, `水平盘读数`. The words are those of `headingWords`. A heading with an
/// unknown word names nothing.
ColumnName columnName(const std::string& text);

/// Do these cells name columns? One at least is known, and none holds a number.
bool areColumnNames(const std::vector<std::string>& cells);

/// Does the row name both circles, or parts of them?
bool nameCircles(const std::vector<std::string>& cells);

}  // namespace alidade
