#pragma once

#include <QLineEdit>
#include <QPointer>
#include <QStyledItemDelegate>

namespace alidade::ui {

/// Edits cells of readings in a line and marks what is wrong, looks misread, is incomplete or excluded. Enter
/// and Tab hand the entry in at once and ask to go onward.
class ReadingDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  static constexpr int signWidth = 14;  ///< of the sign of what is wrong or looks misread, in pixels

  /// Hands in the entry of the open editor, if there is one, and closes it.
  void commitOpenEditor();

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// A click anywhere in the cell ticks or unticks it.
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

 signals:
  void keyOnward(int key);  ///< Return, Tab or Backtab ended the editing

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  mutable QPointer<QLineEdit> m_editor;
};

}  // namespace alidade::ui
