#pragma once

#include "ui/panels/parts/cell_delegate.h"

namespace alidade::ui {

/// Edits cells of readings and marks wrong, suspect, incomplete or excluded ones.
class ReadingDelegate : public CellDelegate {
  Q_OBJECT

 public:
  using CellDelegate::CellDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// A click anywhere in a cell with a check box ticks or unticks the box.
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace alidade::ui
