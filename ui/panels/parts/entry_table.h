#pragma once

#include <QPersistentModelIndex>
#include <QTableView>

class QLineEdit;

namespace alidade::ui {

class CellDelegate;

/// A table to type into, made for the keyboard: typing overwrites, Enter and Tab hand in and go onward, Tab
/// out of the table at its ends. Every edit is one undo step.
class EntryTable : public QTableView {
  Q_OBJECT

 public:
  using QTableView::edit;
  void commitOpenEditor();

  virtual void copy() const = 0;
  virtual void cut() = 0;
  virtual void paste() = 0;
  virtual void clearCells() = 0;

 protected:
  /// `delegate` becomes the table's.
  EntryTable(CellDelegate* delegate, QWidget* parent);

  bool edit(const QModelIndex& cell, EditTrigger trigger, QEvent* event) override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  /// Does what the key stands for. False: it stands for nothing.
  virtual bool handleEditKey(const QKeyEvent* event);
  /// Where Return, Tab or Backtab leads; invalid: out of the table.
  virtual QModelIndex onward(const QModelIndex& from, int key) const = 0;

  /// Selects the cell alone, whichever modifier keys are held.
  void goTo(const QModelIndex& cell);
  /// Where the keyboard begins as long as no cell is current.
  virtual QModelIndex firstCell() const { return {}; }
  void focusInEvent(QFocusEvent* event) override;
  /// The next (`step` 1) or previous (−1) shown cell that can be typed in; invalid at either end of the
  /// table.
  QModelIndex neighbour(const QModelIndex& from, int step) const;

 signals:
  void remark(const QString& text);  ///< for the status line
  /// An editor is open: at each key, and when it opens.
  void typed(const QLineEdit* editor, const QModelIndex& cell);
  void typingEnded(const QLineEdit* editor);  ///< handed in or given up

 private:
  void goOnward(int key);
  bool isLost(const QKeyEvent& event) const;

  CellDelegate* m_delegate;
  QPersistentModelIndex m_edited;  ///< the cell of the open editor
};

}  // namespace alidade::ui
