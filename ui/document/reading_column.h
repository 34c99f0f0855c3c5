#pragma once

#include <string>

#include "core/session/session.h"

namespace alidade::ui {

/// The columns of a table of readings, in the order shown.
enum class ReadingColumn {
  Used,
  Point,
  Round,
  Face,
  Horizontal,
  Vertical,
  Slider,
  HorizontalResidual,
  VerticalResidual,
  Note,
};

inline constexpr int readingColumnCount = 10;

/// The text a column edits; null for the columns that edit none (used, residuals).
std::string Reading::*readingText(ReadingColumn column);

/// The name of the column's value in the session file, `horizontal`; empty for the residuals.
std::string readingFieldName(ReadingColumn column);

/// The column of a reading's field by its name in the session file; `Horizontal` where the name is no
/// column's.
ReadingColumn readingColumn(const std::string& fieldName);

/// Can the column be typed or pasted into? True for the texts and for `Used`.
bool isEntered(ReadingColumn column);

/// What is entered in a column for which `isEntered` holds. `Used` is "1", or "0" where the row is kept out
/// of the fit.
std::string enteredText(const Reading& reading, ReadingColumn column);
void enter(Reading& reading, ReadingColumn column, const std::string& text);

/// Is nothing entered in this row?
bool isBlank(const Reading& reading);

}  // namespace alidade::ui
