#pragma once

#include <QPersistentModelIndex>
#include <QTableView>

class QLineEdit;

namespace alidade::ui {

class CellDelegate;

/// A table for keyboard entry: typing overwrites, Enter and Tab commit and move on, Tab leaves the table at
/// its ends. Every edit is one undo step.
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
  /// The table takes ownership of `delegate`.
  EntryTable(CellDelegate* delegate, QWidget* parent);

  bool edit(const QModelIndex& cell, EditTrigger trigger, QEvent* event) override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  /// Performs the action of the key. Returns false if the key has none.
  virtual bool handleEditKey(const QKeyEvent* event);
  /// The cell to which Return, Tab or Backtab leads; invalid: out of the table.
  virtual QModelIndex onward(const QModelIndex& from, int key) const = 0;

  /// Selects the cell alone, whatever modifier keys are held.
  void goTo(const QModelIndex& cell);
  /// The cell that becomes current when the keyboard enters the table while no cell is current.
  virtual QModelIndex firstCell() const { return {}; }
  void focusInEvent(QFocusEvent* event) override;
  /// The next (`step` 1) or previous (−1) visible editable cell; invalid at either end of the table.
  QModelIndex neighbour(const QModelIndex& from, int step) const;

 signals:
  void remark(const QString& text);  ///< for the status line
  /// Emitted when an editor opens and at each key.
  void typed(const QLineEdit* editor, const QModelIndex& cell);
  void typingEnded(const QLineEdit* editor);  ///< committed or cancelled

 private:
  void goOnward(int key);
  bool isLost(const QKeyEvent& event) const;

  CellDelegate* m_delegate;
  QPersistentModelIndex m_edited;  ///< the cell of the open editor
};

}  // namespace alidade::ui
