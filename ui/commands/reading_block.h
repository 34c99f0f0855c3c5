#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>
#include <vector>

#include "core/exchange/joined_table.h"
#include "ui/document/reading_column.h"

namespace alidade::ui {

/// Cells as they travel over the clipboard, row by row.
using ReadingBlock = QVector<QStringList>;

/// Takes a spreadsheet's text apart: rows end in LF, CRLF or CR; cells are parted by tabs, or by semicolons
/// where there is no tab. A cell in double quotes, inner quotes doubled, is unquoted. Empty rows at the end
/// are dropped, blanks around cells trimmed.
ReadingBlock parseBlock(const QString& text);

/// A block whose first row named its columns. Degrees, minutes and seconds in columns of their own are
/// joined; both faces in one row are rows of their own.
struct NamedBlock {
  ReadingBlock rows;                   ///< without the names; plain numbers with the unit of their column
  std::vector<ReadingColumn> columns;  ///< what the cells of each row are, in turn
  QStringList unplaced;                ///< names of columns that a position has none for
  QString problem;                     ///< why nothing of it can be taken; else empty
};

/// The block as a table whose first rows name its columns; absent where they name none.
std::optional<Result<JoinedTable>> joinedBlock(const ReadingBlock& block);

/// Absent where the first row names no columns (`areColumnNames`), or stands alone.
std::optional<NamedBlock> namedBlock(const ReadingBlock& block);

/// The text of a block, cell by cell: tabs and LF. Tabs and line ends inside a cell become blanks.
class BlockText {
 public:
  void beginRow();
  void add(const QString& cell);
  const QString& text() const { return m_text; }

 private:
  QString m_text;
  bool m_hasRow = false, m_hasCell = false;  ///< the second: in the row begun last
};

/// The reverse of `parseBlock`.
QString blockText(const ReadingBlock& block);

}  // namespace alidade::ui
