#include "ui/panels/parts/entry_table.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

#include "ui/panels/parts/cell_delegate.h"

namespace alidade::ui {

EntryTable::EntryTable(CellDelegate* delegate, QWidget* parent) : QTableView(parent), m_delegate(delegate) {
  delegate->setParent(this);
  setItemDelegate(delegate);
  setEditTriggers(AnyKeyPressed | DoubleClicked | EditKeyPressed);
  setSelectionMode(ExtendedSelection);
  setAlternatingRowColors(true);
  setWordWrap(false);
  setHorizontalScrollMode(ScrollPerPixel);
  setTabKeyNavigation(false);
  connect(m_delegate, &CellDelegate::keyOnward, this, &EntryTable::goOnward);
}

void EntryTable::commitOpenEditor() {
  m_delegate->commitOpenEditor();
}

/// A key that opens an editor is already typed into the editor when `QTableView::edit` returns.
bool EntryTable::edit(const QModelIndex& cell, EditTrigger trigger, QEvent* event) {
  const QLineEdit* before = m_delegate->openEditor();
  if (!QTableView::edit(cell, trigger, event)) return false;
  const QLineEdit* editor = m_delegate->openEditor();
  if (!editor || editor == before) return true;
  m_edited = cell;
  connect(editor, &QLineEdit::textEdited, this, [this, editor] { emit typed(editor, m_edited); });
  emit typed(editor, m_edited);
  return true;
}

void EntryTable::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
  emit typingEnded(qobject_cast<QLineEdit*>(editor));
  QTableView::closeEditor(editor, hint);
}

void EntryTable::goTo(const QModelIndex& cell) {
  selectionModel()->setCurrentIndex(cell, QItemSelectionModel::ClearAndSelect);
  scrollTo(cell);
}

void EntryTable::keyPressEvent(QKeyEvent* event) {
  if (state() == EditingState) {
    QTableView::keyPressEvent(event);
    return;
  }
  const int key = event->key();
  if (handleEditKey(event)) {
    event->accept();
  } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    goOnward(Qt::Key_Return);
  } else if (isLost(*event)) {
    QApplication::beep();
    emit remark(tr("Nothing was entered: this cell takes no numbers."));
  } else {
    QTableView::keyPressEvent(event);
  }
}

/// True for a digit typed in a cell that is not editable.
bool EntryTable::isLost(const QKeyEvent& event) const {
  const bool isDigit = event.text().size() == 1 && event.text().front().isDigit();
  return isDigit && currentIndex().isValid() && !currentIndex().flags().testFlag(Qt::ItemIsEditable);
}

/// Makes `firstCell` current. Qt would start at the first column, whatever its contents.
void EntryTable::focusInEvent(QFocusEvent* event) {
  const QModelIndex first = firstCell();
  if (!currentIndex().isValid() && first.isValid() && event->reason() != Qt::MouseFocusReason) goTo(first);
  QTableView::focusInEvent(event);
}

/// Tab and Shift+Tab move from cell to cell and leave the table at its ends.
bool EntryTable::focusNextPrevChild(bool next) {
  const int key = next ? Qt::Key_Tab : Qt::Key_Backtab;
  if (state() == EditingState || !onward(currentIndex(), key).isValid())
    return QTableView::focusNextPrevChild(next);
  goOnward(key);
  return true;
}

bool EntryTable::handleEditKey(const QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copy();
  } else if (event->matches(QKeySequence::Cut)) {
    cut();
  } else if (event->matches(QKeySequence::Paste)) {
    paste();
  } else if (event->matches(QKeySequence::Delete)) {
    clearCells();
  } else {
    return false;
  }
  return true;
}

void EntryTable::goOnward(int key) {
  const QModelIndex next = onward(currentIndex(), key);
  if (next.isValid()) goTo(next);
}

QModelIndex EntryTable::neighbour(const QModelIndex& from, int step) const {
  int row = from.row(), column = from.column();
  while (true) {
    column += step;
    if (column < 0 || column >= model()->columnCount()) {
      row += step;
      column = step > 0 ? 0 : model()->columnCount() - 1;
    }
    if (row < 0 || row >= model()->rowCount()) return {};
    const QModelIndex cell = model()->index(row, column);
    if (!isColumnHidden(column) && cell.flags().testFlag(Qt::ItemIsEditable)) return cell;
  }
}

}  // namespace alidade::ui
