#pragma once

#include <QLineEdit>
#include <QPointer>
#include <QStyledItemDelegate>

#include "ui/settings/theme.h"

namespace alidade::ui {

/// Edits cells of texts in a line. Enter and Tab hand the entry in at once and ask to go onward.
class CellDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  static constexpr int signWidth = 14;  ///< of the sign of what is wrong or looks misread, in pixels

  /// Null where none is open.
  QLineEdit* openEditor() const;
  /// Hands in the entry of the open editor, if there is one, and closes it.
  void commitOpenEditor();

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  /// Leaves alone what is half typed.
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 signals:
  void keyOnward(int key);  ///< Return, Tab or Backtab ended the editing

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// A sign and a tint.
  static void mark(QStyleOptionViewItem& option, const QString& icon, State state);
  /// A tint alone: an entry still to be made.
  static void markIncomplete(QStyleOptionViewItem& option);
  /// As what is not typed here.
  static void setQuiet(QStyleOptionViewItem& option);

 private:
  mutable QPointer<QLineEdit> m_editor;
};

}  // namespace alidade::ui
