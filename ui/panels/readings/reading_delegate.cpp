#include "ui/panels/readings/reading_delegate.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include "ui/models/readings_model.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

namespace {

/// Paints the sign of a cell that differs from its first entry.
void paintCorner(QPainter& painter, const QStyleOptionViewItem& option) {
  constexpr int side = 7;
  const QPoint corner = option.rect.topRight() + QPoint(1, 0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const bool isSelected = option.state.testFlag(QStyle::State_Selected);
  painter.setBrush(option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Link));
  painter.drawPolygon(QPolygon({corner - QPoint(side, 0), corner, corner + QPoint(0, side)}));
  painter.restore();
}

}  // namespace

bool ReadingDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                                  const QStyleOptionViewItem& option, const QModelIndex& index) {
  const QVariant checked = index.data(Qt::CheckStateRole);
  if (!checked.isValid()) return CellDelegate::editorEvent(event, model, option, index);
  if (event->type() != QEvent::MouseButtonRelease) return false;
  if (static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return false;
  const auto toggled = checked.toInt() == Qt::Checked ? Qt::Unchecked : Qt::Checked;
  return model->setData(index, toggled, Qt::CheckStateRole);
}

void ReadingDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  CellDelegate::initStyleOption(option, index);
  const bool wrong = !index.data(ReadingsModel::ProblemRole).toString().isEmpty();
  const bool doubtful = !wrong && !index.data(ReadingsModel::SuspectRole).toString().isEmpty();
  if (wrong)
    mark(*option, QStringLiteral("problem"), State::Bad);
  else if (doubtful)
    mark(*option, QStringLiteral("warning"), State::Open);
  else if (index.data(ReadingsModel::IncompleteRole).toBool())
    markIncomplete(*option);
  const bool excluded = index.data(ReadingsModel::ExcludedRole).toBool();
  const auto column = static_cast<ReadingColumn>(index.column());
  option->font.setStrikeOut(excluded && !isFreeText(column));
  const bool computed = !isEntered(column);
  if (excluded || computed || index.data(ReadingsModel::PendingRowRole).toBool()) setQuiet(*option);
}

void ReadingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  if (static_cast<ReadingColumn>(index.column()) != ReadingColumn::Used) {
    CellDelegate::paint(painter, option, index);
    if (index.data(ReadingsModel::ChangedRole).toBool()) paintCorner(*painter, option);
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
  if (isDark(option.palette)) {  // Fusion draws the frame from the window colour, invisible on a dark base
    box.palette.setColor(QPalette::Window, option.palette.color(QPalette::PlaceholderText));
  }
  box.state = QStyle::State_Enabled | (checked.toInt() == Qt::Checked ? QStyle::State_On : QStyle::State_Off);
  style->drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, painter, cell.widget);
}

}  // namespace alidade::ui
