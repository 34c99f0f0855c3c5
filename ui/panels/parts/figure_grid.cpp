#include "ui/panels/parts/figure_grid.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QPainter>
#include <QSet>
#include <algorithm>

#include "ui/settings/window_font.h"

namespace alidade::ui {

namespace {

constexpr int tickColumn = 0, captionColumn = 1, firstFigure = 2;

constexpr int gridRow(int row) {
  return 1 + 2 * row;  // a row for texts follows each row of figures
}

void setBold(QWidget& widget, bool isBold) {
  QFont font;  // sets only the weight, so that size and family stay those of the grid
  font.setBold(isBold);
  widget.setFont(font);
}

}  // namespace

/// A label with a bar behind its text.
class FigureGrid::Figure : public QLabel {
 public:
  void setBar(const std::optional<double>& bar) {
    m_bar = bar;
    setContentsMargins(bar ? 4 : 0, 0, bar ? 4 : 0, 0);
    update();
  }

  /// Wide enough for a figure with its uncertainty and unit in one line. QLabel's own hint breaks it.
  QSize sizeHint() const override {
    constexpr int longest = 24;  // average characters
    const QFontMetricsF metrics(font());
    const double line = std::min(metrics.horizontalAdvance(text()), longest * metrics.averageCharWidth());
    const QMargins margins = contentsMargins();
    const QSize hint = QLabel::sizeHint();
    return {std::max(hint.width(), static_cast<int>(line) + 2 + margins.left() + margins.right()),
            hint.height()};
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    if (m_bar) {
      QPainter painter(this);
      QColor whole = palette().color(QPalette::Highlight);
      whole.setAlphaF(0.1F);
      painter.fillRect(rect(), whole);
      whole.setAlphaF(0.4F);
      painter.fillRect(QRectF(0, 0, width() * std::clamp(*m_bar, 0.0, 1.0), height()), whole);
    }
    QLabel::paintEvent(event);
  }

 private:
  std::optional<double> m_bar;
};

FigureGrid::FigureGrid(QWidget* parent, Captions captions)
    : QWidget(parent), m_grid(new QGridLayout(this)), m_captions(captions) {
  m_grid->setContentsMargins(0, 0, 0, 0);
  m_grid->setHorizontalSpacing(8);
  m_grid->setVerticalSpacing(3);
  m_grid->setColumnStretch(captionColumn, 1);
  scaleFont(*this, 0.95);
}

void FigureGrid::setRows(const QStringList& titles, const QVector<Row>& rows, int barColumn) {
  QSet<QWidget*> shown;
  const auto show = [&](int row, int column, const QString& text, const QString& toolTip) {
    Figure* figure = label(row, column);
    figure->setText(text);
    figure->setToolTip(toolTip);
    shown.insert(figure);
    return figure;
  };
  const bool titled =
      std::any_of(titles.begin(), titles.end(), [](const QString& title) { return !title.isEmpty(); });
  for (int column = 0; titled && column < titles.size(); ++column)
    show(0, firstFigure + column, titles[column], {})
        ->setAlignment((column == barColumn ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
  for (int i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    Figure* caption = show(gridRow(i), captionColumn, row.caption, row.toolTip);
    caption->setContentsMargins(row.isPart ? 14 : 0, 0, 0, 0);
    setBold(*caption, row.isBold);
    for (int column = 0; column < titles.size(); ++column) {
      Figure* figure = show(gridRow(i), firstFigure + column, row.figures.value(column), row.toolTip);
      figure->setFocusPolicy(figure->text().isEmpty() ? Qt::NoFocus : Qt::ClickFocus);
      setBold(*figure, row.isBold);
      figure->setBar(column == barColumn ? row.bar : std::nullopt);
      figure->setAlignment((column == barColumn ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      figure->setWordWrap(barColumn >= 0);  // beside a bar there is little room
    }
    if (!row.below.isEmpty()) show(gridRow(i) + 1, captionColumn, row.below.join(u'\n'), {});
  }
  if (barColumn >= 0) m_grid->setColumnStretch(firstFigure + barColumn, 1);
  for (int i = 0; i < m_grid->count(); ++i)
    m_grid->itemAt(i)->widget()->setVisible(shown.contains(m_grid->itemAt(i)->widget()));
  showTicks(rows);
}

void FigureGrid::showTicks(const QVector<Row>& rows) {
  qDeleteAll(m_ticks);
  m_ticks.clear();
  for (int i = 0; i < rows.size(); ++i) {
    const QString& id = rows[i].tick;
    if (id.isEmpty()) continue;
    auto* tick = new QCheckBox;
    tick->setObjectName(id);
    tick->setAccessibleName(rows[i].caption);
    tick->setToolTip(rows[i].toolTip);
    tick->setChecked(rows[i].isTicked);
    connect(tick, &QCheckBox::toggled, this, &FigureGrid::ticksChanged);
    m_grid->addWidget(tick, gridRow(i), tickColumn);
    m_ticks.append(tick);
  }
}

QStringList FigureGrid::ticked() const {
  QStringList ids;
  for (const QCheckBox* tick : m_ticks)
    if (tick->isChecked()) ids.append(tick->objectName());
  return ids;
}

FigureGrid::Figure* FigureGrid::label(int row, int column) {
  if (QLayoutItem* item = m_grid->itemAtPosition(row, column)) return static_cast<Figure*>(item->widget());
  auto* label = new Figure;
  const bool isTitle = row == 0, isCaption = column == captionColumn, isBelow = isCaption && row % 2 == 0;
  if (isTitle || isBelow) label->setForegroundRole(QPalette::PlaceholderText);
  label->setWordWrap(isBelow || ((isTitle || isCaption) && m_captions == Captions::Wrapped));
  if (!isTitle && !isCaption) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setFocusPolicy(Qt::ClickFocus);
  }
  if (isBelow)
    m_grid->addWidget(label, row, captionColumn, 1, -1);
  else
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
