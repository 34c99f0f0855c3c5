#include "ui/instrument/check_rows_table.h"

#include <QHeaderView>

#include "ui/panels/parts/cell_delegate.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

CheckRowsTable::CheckRowsTable(QWidget* parent) : EntryTable(new CellDelegate, parent) {
  setModel(&m_model);
  setAccessibleName(tr("Rounds typed"));
  setToolTip(tr("Type, or paste from a spreadsheet (Ctrl+V); a first row of column names sets their order"));
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
  horizontalHeader()->setHighlightSections(false);
  const char* const widest[CheckRowsModel::columns] = {"Pillar 12",    "Round",        "Target 12",   "Face",
                                                       "379.85926gon", "379.85926gon", "Distance (m)"};
  for (int column = 0; column < CheckRowsModel::columns; ++column)
    setColumnWidth(column, fontMetrics().horizontalAdvance(QString::fromUtf8(widest[column])) + 18);
}

void CheckRowsTable::copy() const {
  ReadingBlock block;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row) {
      QStringList cells;
      for (int column = range.left(); column <= range.right(); ++column)
        cells.append(m_model.index(row, column).data(Qt::EditRole).toString());
      block.append(cells);
    }
  if (!block.isEmpty()) copyBlock(blockText(block));
}

void CheckRowsTable::cut() {
  copy();
  clearCells();
}

void CheckRowsTable::paste() {
  const QModelIndex corner = currentIndex();
  if (const auto problem =
          m_model.paste(clipboardBlock(), std::max(corner.row(), 0), std::max(corner.column(), 0)))
    emit remark(tr("The clipboard was not pasted: %1.").arg(visibleLine(problem->what)));
}

void CheckRowsTable::clearCells() {
  m_model.clear(selectionModel()->selectedIndexes());
}

QModelIndex CheckRowsTable::onward(const QModelIndex& from, int key) const {
  if (!from.isValid()) return firstCell();
  return neighbour(from, key == Qt::Key_Backtab ? -1 : 1);
}

}  // namespace alidade::ui
