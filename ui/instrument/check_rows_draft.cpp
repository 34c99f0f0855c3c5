#include "ui/instrument/check_rows_draft.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QLineEdit>

#include "ui/instrument/check_rows_table.h"
#include "ui/recovery/drafts.h"

namespace alidade::ui {

namespace {

const QString rowsForm = QStringLiteral("instrument check"),
              cellForm = QStringLiteral("instrument check, open cell");
const QLatin1String rowsKey("rows"), rowKey("row"), columnKey("column"), textKey("text");

ReadingBlock blockOf(const QJsonObject& draft) {
  ReadingBlock block;
  for (const QJsonValue& row : draft.value(rowsKey).toArray()) {
    QStringList cells;
    for (const QJsonValue& cell : row.toArray()) cells.append(cell.toString());
    block.append(cells);
  }
  return block;
}

QJsonObject draftOf(const ReadingBlock& block) {
  QJsonArray rows;
  for (const QStringList& cells : block) rows.append(QJsonArray::fromStringList(cells));
  return {{rowsKey, rows}};
}

}  // namespace

/// Stores the open cell apart from the committed rows, so that a key typed in the cell copies no rows.
CheckRowsDraft::CheckRowsDraft(CheckRowsTable& table) : QObject(&table), m_table(table) {
  restore();
  connect(&table.rows(), &CheckRowsModel::edited, this, &CheckRowsDraft::keepRows);
  connect(&table, &EntryTable::typed, this, [](const QLineEdit* editor, const QModelIndex& cell) {
    drafts().set(cellForm, {{rowKey, cell.row()}, {columnKey, cell.column()}, {textKey, editor->text()}});
  });
  connect(&table, &EntryTable::typingEnded, this, [] { drafts().set(cellForm, {}); });
}

void CheckRowsDraft::restore() {
  CheckRowsModel& rows = m_table.rows();
  const QJsonObject kept = drafts().of(rowsForm), open = drafts().of(cellForm);
  if (!kept.isEmpty()) rows.restore(blockOf(kept));
  const int row = open.value(rowKey).toInt(-1), column = open.value(columnKey).toInt(-1);
  if (row < 0 || row >= rows.rowCount()) return;
  rows.setData(rows.index(row, column), open.value(textKey).toString(), Qt::EditRole);
  drafts().set(cellForm, {});
  keepRows();
}

void CheckRowsDraft::keepRows() {
  const CheckRowsModel& rows = m_table.rows();
  drafts().set(rowsForm, rows.isBlank() ? QJsonObject() : draftOf(rows.block()));
}

}  // namespace alidade::ui
