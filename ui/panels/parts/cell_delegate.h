#pragma once

#include <QLineEdit>
#include <QPointer>
#include <QStyledItemDelegate>

#include "ui/settings/theme.h"

namespace alidade::ui {

/// Edits text cells in a line edit. Enter and Tab commit the entry and emit `keyOnward`.
class CellDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  static constexpr int signWidth = 14;  ///< width of the error or suspect sign, in pixels

  /// The editor that is open; null if there is none.
  QLineEdit* openEditor() const;
  /// Commits and closes the open editor, if there is one.
  void commitOpenEditor();

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  /// Does not overwrite an unfinished entry.
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 signals:
  void keyOnward(int key);  ///< Return, Tab or Backtab ended the editing

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Marks a cell with a sign and a tint.
  static void mark(QStyleOptionViewItem& option, const QString& icon, State state);
  /// Tints an entry still to be made.
  static void markIncomplete(QStyleOptionViewItem& option);
  /// Shows a cell as not editable.
  static void setQuiet(QStyleOptionViewItem& option);

 private:
  mutable QPointer<QLineEdit> m_editor;
};

}  // namespace alidade::ui
