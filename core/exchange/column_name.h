#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/recording.h"
#include "core/exchange/table_column.h"

namespace alidade {

/// The meaning of a column's heading.
struct ColumnName {
  std::optional<TableColumn> column = {};
  AngleUnit unit = AngleUnit::Unstated;
  std::string verticalCircle = {};  ///< kind of vertical circle that the name states; may be empty
  double metres = 1;                ///< per unit of a distance
  bool isHorizontal = false;        ///< the distance is horizontal
  bool isPart = false;  ///< degrees, minutes or seconds of `column`, or of the heading to the left or above
  AnglePart part = AnglePart::Degrees;
  bool isCentesimal = false;  ///< minutes and seconds are hundredths
  bool isGrad = false;        ///< the unit is called grad: degrees in German, gon in French
  int face = 0;               ///< 1 or 2 if the name states the face, else 0
  bool isWeak = false;        ///< ambiguous, `H` or `No`: used only if no other heading names this field
  bool isSpanish = false;     ///< the letters D and I of a face mean directo and inverso
  bool isUnderstood = false;  ///< there is at least one word, and all are known
};

/// Returns the meaning of a heading. Case, accents, blanks, _ and words such as “angle”, “circle” and
/// “reading” do not matter: `Hz [gon]`, `v_deg`, `Horizontalwinkel`, `水平盘读数`. The words are those of
/// `headingWords`. A heading with an unknown word names nothing.
ColumnName columnName(const std::string& text);

/// Do these cells name columns? At least one cell is a known name, and no cell is a number or an angle.
bool areColumnNames(const std::vector<std::string>& cells);

/// Does the row name both circles, or parts of them?
bool nameCircles(const std::vector<std::string>& cells);

}  // namespace alidade
