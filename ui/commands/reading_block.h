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
/// tab. A cell in double quotes, inner quotes doubled, is unquoted. Drops empty rows at the end and trims
/// blanks around cells.
ReadingBlock parseBlock(const QString& text);

/// A block whose first row named its columns. Separate columns of degrees, minutes and seconds are joined;
/// two faces in one row become two rows.
struct NamedBlock {
  ReadingBlock rows;                   ///< without the names; plain numbers with the unit of their column
  std::vector<ReadingColumn> columns;  ///< the columns of the cells in each row
  QStringList unplaced;                ///< names of columns that readings do not have
  QString problem;                     ///< why the block is unusable; else empty
};

/// The block as a table whose first rows name its columns; absent if the first row names none.
std::optional<Result<JoinedTable>> joinedBlock(const ReadingBlock& block);

/// Absent if the first row does not name columns of readings (`areColumnNames`), or is the only row.
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
  bool m_hasRow = false, m_hasCell = false;  ///< `m_hasCell`: the row begun last has a cell
};

/// The reverse of `parseBlock`.
QString blockText(const ReadingBlock& block);

}  // namespace alidade::ui
