#pragma once

#include <span>
#include <string>

#include "core/session/row_fields.h"
#include "core/session/session.h"

namespace alidade::ui {

/// The columns of a table of rows, in the order shown.
enum class ReadingColumn {
  Used,
  Point,
  Round,
  Face,
  Horizontal,
  Vertical,
  Slider,
  TiltCross,
  TiltLength,
  Corrections,
  TakenAt,
  ReturnCode,
  InstrumentSerial,
  HorizontalResidual,
  VerticalResidual,
  Note,
};

inline constexpr int readingColumnCount = static_cast<int>(ReadingColumn::Note) + 1;

/// The contents of a column and its form in window and report. Title, tool tip, noun and menu text are in
/// English, for translation in the context "ReadingColumn".
struct ReadingColumnInfo {
  ReadingColumn column;
  const RowField* field;  ///< the edited field of the row; null: not editable, as for residuals
  const char* title;
  const char* toolTip;
  const char* noun;          ///< in undo texts and messages; null if not editable
  const char* menuText;      ///< menu item that shows the column while no row uses it; null: always shown
  const char* widest;        ///< text that sets the width; null: an angle, as wide as the table allows
  const char* printedTitle;  ///< title in the report; null: not printed
  double printedWidth;       ///< mm
};

/// All columns, in the order shown.
std::span<const ReadingColumnInfo> allReadingColumns();

const ReadingColumnInfo& infoOf(ReadingColumn column);

/// The text of a row that the column edits; null for columns without a text (`Used`, residuals).
std::string Reading::*readingText(ReadingColumn column);

/// The column of a row's field by its name in the session file; `Horizontal` if no column has the name.
ReadingColumn readingColumn(const std::string& fieldName);

/// True if the column holds typed angles.
bool isAngle(ReadingColumn column);

/// True if the column holds free text.
bool isFreeText(ReadingColumn column);

/// True if the column accepts typing and pasting: the texts and `Used`.
bool isEntered(ReadingColumn column);

/// The entry of a column for which `isEntered` is true. `Used` is "1", or "0" if the row is excluded.
std::string enteredText(const Reading& row, ReadingColumn column);
void enter(Reading& row, ReadingColumn column, const std::string& text);

}  // namespace alidade::ui
