#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>
#include <vector>

#include "core/exchange/joined_table.h"
#include "ui/document/reading_column.h"

namespace alidade::ui {

/// Cells in clipboard form, row by row.
using ReadingBlock = QVector<QStringList>;

/// Parses a spreadsheet's text: rows end in LF, CRLF or CR; tabs separate cells, or semicolons if there is no
/// tab. Removes the double quotes around a cell and halves doubled quotes inside. Drops empty rows at the
/// end and trims blanks around cells.
ReadingBlock parseBlock(const QString& text);

/// A block whose first row named its columns. Separate columns of degrees, minutes and seconds are joined;
/// two faces in one row become two rows.
struct NamedBlock {
  ReadingBlock rows;                   ///< without the names; plain numbers are in the unit of their column
  std::vector<ReadingColumn> columns;  ///< column of each cell in a row
  QStringList unplaced;                ///< names of columns that readings do not have
  QString problem;                     ///< why the block is unusable; else empty
};

/// The block as a table whose first rows name its columns. Absent if the first row names no columns, or if no
/// row follows.
std::optional<Result<JoinedTable>> joinedBlock(const ReadingBlock& block);

/// Absent if the first row names no columns of readings (`areColumnNames`), or if no row follows. Unusable if
/// unnamed columns hold angles in parts: degrees are never read alone.
std::optional<NamedBlock> namedBlock(const ReadingBlock& block);

/// Builds the text of a block, cell by cell, with tabs and LF. Tabs and line ends inside a cell become
/// blanks.
class BlockText {
 public:
  void beginRow();
  void add(const QString& cell);
  const QString& text() const { return m_text; }

 private:
  QString m_text;
  bool m_hasRow = false, m_hasCell = false;  ///< `m_hasCell`: the current row has a cell
};

/// The reverse of `parseBlock`.
QString blockText(const ReadingBlock& block);

/// Puts the text of a block on the clipboard. Tables of this program get its cells back as they are, even
/// with semicolons or quotation marks; other programs get the text.
void copyBlock(const QString& text);
/// The block on the clipboard, from this program or by `parseBlock`.
ReadingBlock clipboardBlock();

}  // namespace alidade::ui
