#include "ui/panels/readings/reading_delegate.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <limits>

#include "ui/models/readings_model.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

/// One that was closed is hidden, and there until events are processed.
void ReadingDelegate::commitOpenEditor() {
  if (!m_editor || m_editor->isHidden()) return;
  QLineEdit* editor = m_editor;
  emit commitData(editor);
  emit closeEditor(editor, NoHint);
}

QWidget* ReadingDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                       const QModelIndex& index) const {
  auto* editor = new QLineEdit(parent);
  editor->setFrame(false);
  editor->setMaxLength(std::numeric_limits<int>::max());  // or a long text would lose its end
  editor->setAlignment(static_cast<Qt::Alignment>(index.data(Qt::TextAlignmentRole).toInt()));
  editor->setAccessibleName(
      index.model()->headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString());
  m_editor = editor;
  return editor;
}

void ReadingDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  static_cast<QLineEdit*>(editor)->setText(index.data(Qt::EditRole).toString());
}

void ReadingDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                   const QModelIndex& index) const {
  const auto* line = static_cast<QLineEdit*>(editor);
  if (line->isModified()) model->setData(index, line->text(), Qt::EditRole);
}

bool ReadingDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                                  const QStyleOptionViewItem& option, const QModelIndex& index) {
  const QVariant checked = index.data(Qt::CheckStateRole);
  if (!checked.isValid()) return QStyledItemDelegate::editorEvent(event, model, option, index);
  if (event->type() != QEvent::MouseButtonRelease) return false;
  if (static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return false;
  const auto toggled = checked.toInt() == Qt::Checked ? Qt::Unchecked : Qt::Checked;
  return model->setData(index, toggled, Qt::CheckStateRole);
}

bool ReadingDelegate::eventFilter(QObject* watched, QEvent* event) {
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

void ReadingDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const bool wrong = !index.data(ReadingsModel::ProblemRole).toString().isEmpty();
  const bool doubtful = !wrong && !index.data(ReadingsModel::SuspectRole).toString().isEmpty();
  if (wrong || doubtful) {
    option->icon = themeIcon(wrong ? QStringLiteral("problem") : QStringLiteral("warning"));
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->decorationSize = {signWidth, signWidth};
    option->backgroundBrush = stateTint(option->palette, wrong ? State::Bad : State::Open);
  } else if (index.data(ReadingsModel::IncompleteRole).toBool()) {
    option->backgroundBrush = stateTint(option->palette, State::Open);
  }
  const bool excluded = index.data(ReadingsModel::ExcludedRole).toBool();
  const auto column = static_cast<ReadingColumn>(index.column());
  option->font.setStrikeOut(excluded && !isFreeText(column));
  const bool computed = !isEntered(column);
  if (excluded || computed || index.data(ReadingsModel::PendingRowRole).toBool()) {
    option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
  }
}

void ReadingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  if (static_cast<ReadingColumn>(index.column()) != ReadingColumn::Used) {
    QStyledItemDelegate::paint(painter, option, index);
    return;
  }
  QStyleOptionViewItem cell = option;
  initStyleOption(&cell, index);
  cell.features &= ~QStyleOptionViewItem::HasCheckIndicator;
  QStyle* style = cell.widget ? cell.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
  const QVariant checked = index.data(Qt::CheckStateRole);
  if (!checked.isValid()) return;
  QStyleOptionButton box;
  box.rect = style->subElementRect(QStyle::SE_CheckBoxIndicator, &box, cell.widget);
  box.rect.moveCenter(option.rect.center());
  box.palette = option.palette;
  if (isDark(option.palette)) {  // Fusion draws the frame from the window colour, unseen on a dark base
    box.palette.setColor(QPalette::Window, option.palette.color(QPalette::PlaceholderText));
  }
  box.state = QStyle::State_Enabled | (checked.toInt() == Qt::Checked ? QStyle::State_On : QStyle::State_Off);
  style->drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, painter, cell.widget);
}

}  // namespace alidade::ui
