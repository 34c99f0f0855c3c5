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

/// What a column holds and how it looks in the window and in the report. Title, tool tip, noun and menu text
/// are in English, to be translated in the context "ReadingColumn".
struct ReadingColumnInfo {
  ReadingColumn column;
  const RowField* field;  ///< of the row that it edits; null: it edits none, as the residuals
  const char* title;
  const char* toolTip;
  const char* noun;          ///< in undo texts and messages; null where nothing is edited
  const char* menuText;      ///< to show it where no row uses it; null: it is always shown
  const char* widest;        ///< text that it has room for; null: an angle, whose room depends on the table's
  const char* printedTitle;  ///< in the report; null: the report has no such column
  double printedWidth;       ///< mm
};

/// All of them, in the order shown.
std::span<const ReadingColumnInfo> allReadingColumns();

const ReadingColumnInfo& infoOf(ReadingColumn column);

/// The text a column edits; null for the columns that edit none (used, residuals).
std::string Reading::*readingText(ReadingColumn column);

/// The column of a row's field by its name in the session file; `Horizontal` where the name is no column's.
ReadingColumn readingColumn(const std::string& fieldName);

/// Does the column hold angles that are typed?
bool isAngle(ReadingColumn column);

/// Does it hold any text?
bool isFreeText(ReadingColumn column);

/// Can the column be typed or pasted into? True for the texts and for `Used`.
bool isEntered(ReadingColumn column);

/// What is entered in a column for which `isEntered` holds. `Used` is "1", or "0" where the row is kept out
/// of the fit.
std::string enteredText(const Reading& row, ReadingColumn column);
void enter(Reading& row, ReadingColumn column, const std::string& text);

}  // namespace alidade::ui
