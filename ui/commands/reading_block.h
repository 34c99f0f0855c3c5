#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

namespace alidade::ui {

/// Cells as they travel over the clipboard, row by row.
using ReadingBlock = QVector<QStringList>;

/// Takes a spreadsheet's text apart: rows end in LF, CRLF or CR; cells are parted by tabs, or by semicolons
/// where there is no tab. A cell in double quotes, inner quotes doubled, is unquoted. Empty rows at the end
/// are dropped, blanks around cells trimmed.
ReadingBlock parseBlock(const QString& text);

/// The reverse: tabs and LF. Tabs and line ends inside a cell become blanks.
QString blockText(const ReadingBlock& block);

}  // namespace alidade::ui
