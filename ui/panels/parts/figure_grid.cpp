#include "ui/panels/parts/figure_grid.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>

#include "ui/settings/window_font.h"

namespace alidade::ui {

FigureGrid::FigureGrid(QWidget* parent, Captions captions)
    : QWidget(parent), m_grid(new QGridLayout(this)), m_captions(captions) {
  m_grid->setContentsMargins(0, 0, 0, 0);
  m_grid->setHorizontalSpacing(8);
  m_grid->setVerticalSpacing(3);
  m_grid->setColumnStretch(0, 1);
  scaleFont(*this, 0.95);
}

void FigureGrid::setRows(const QStringList& titles, const QVector<Row>& rows) {
  const int columns = static_cast<int>(titles.size());
  for (int column = 0; column < columns; ++column) label(0, column + 1)->setText(titles[column]);
  for (int i = 0; i < rows.size(); ++i) {
    QLabel* caption = label(i + 1, 0);
    caption->setText(rows[i].caption);
    caption->setToolTip(rows[i].toolTip);
    for (int column = 0; column < columns; ++column) {
      QLabel* figure = label(i + 1, column + 1);
      figure->setText(rows[i].figures.value(column));
      figure->setFocusPolicy(figure->text().isEmpty() ? Qt::NoFocus : Qt::ClickFocus);
      figure->setToolTip(rows[i].toolTip);
    }
  }
  const bool titled =
      std::any_of(titles.begin(), titles.end(), [](const QString& title) { return !title.isEmpty(); });
  for (int i = 0; i < m_grid->count(); ++i) {
    int row = 0, column = 0, rowSpan = 0, columnSpan = 0;
    m_grid->getItemPosition(i, &row, &column, &rowSpan, &columnSpan);
    m_grid->itemAt(i)->widget()->setVisible(row <= rows.size() && column <= columns && (row > 0 || titled));
  }
}

QLabel* FigureGrid::label(int row, int column) {
  if (QLayoutItem* item = m_grid->itemAtPosition(row, column)) return static_cast<QLabel*>(item->widget());
  auto* label = new QLabel;
  if (row == 0) label->setForegroundRole(QPalette::PlaceholderText);
  if (column > 0) label->setAlignment(Qt::AlignRight | (row == 0 ? Qt::AlignBottom : Qt::AlignVCenter));
  if (column == 0) label->setWordWrap(m_captions == Captions::Wrapped);
  if (row > 0 && column > 0) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setFocusPolicy(Qt::ClickFocus);
  }
  m_grid->addWidget(label, row, column);
  return label;
}

QLabel* panelHeading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 8, 0, 0);
  return label;
}

QLabel* wrappedLabel() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace alidade::ui
