#include "ui/panels/parts/cell_delegate.h"

#include <QKeyEvent>
#include <limits>

namespace alidade::ui {

/// A closed editor is hidden at once, but exists until events are processed.
QLineEdit* CellDelegate::openEditor() const {
  return m_editor && !m_editor->isHidden() ? m_editor.data() : nullptr;
}

void CellDelegate::commitOpenEditor() {
  QLineEdit* editor = openEditor();
  if (!editor) return;
  emit commitData(editor);
  emit closeEditor(editor, NoHint);
}

QWidget* CellDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
  auto* editor = new QLineEdit(parent);
  editor->setFrame(false);
  editor->setMaxLength(std::numeric_limits<int>::max());  // otherwise a long text would be truncated
  editor->setAlignment(static_cast<Qt::Alignment>(index.data(Qt::TextAlignmentRole).toInt()));
  editor->setAccessibleName(
      index.model()->headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString());
  m_editor = editor;
  return editor;
}

void CellDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* line = static_cast<QLineEdit*>(editor);
  const QString text = index.data(Qt::EditRole).toString();
  if (!line->isModified() && line->text() != text) line->setText(text);
}

void CellDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  const auto* line = static_cast<QLineEdit*>(editor);
  if (line->isModified()) model->setData(index, line->text(), Qt::EditRole);
}

bool CellDelegate::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && watched == m_editor) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool isReturn = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (isReturn || key == Qt::Key_Tab || key == Qt::Key_Backtab) {
      commitOpenEditor();
      emit keyOnward(isReturn ? Qt::Key_Return : key);
      return true;
    }
  }
  return QStyledItemDelegate::eventFilter(watched, event);
}

void CellDelegate::mark(QStyleOptionViewItem& option, const QString& icon, State state) {
  option.icon = themeIcon(icon);
  option.features |= QStyleOptionViewItem::HasDecoration;
  option.decorationSize = {signWidth, signWidth};
  option.backgroundBrush = stateTint(option.palette, state);
}

void CellDelegate::markIncomplete(QStyleOptionViewItem& option) {
  option.backgroundBrush = stateTint(option.palette, State::Open);
}

void CellDelegate::setQuiet(QStyleOptionViewItem& option) {
  option.palette.setColor(QPalette::Text, option.palette.color(QPalette::PlaceholderText));
}

}  // namespace alidade::ui
