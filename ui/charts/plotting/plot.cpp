#include "ui/charts/plotting/plot.h"

#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/charts/plotting/round_numbers.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

constexpr double markReach = 9;  // scene units within which a point counts as meant

/// Writes −12.5: a real minus sign and a decimal point. No English locale does.
QLocale axisLocale() {
  QLocale locale(QLocale::Romansh, QLocale::Switzerland);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

}  // namespace

Plot::Plot(QObject* parent) : QObject(parent), m_chart(new QChart), m_x(new QValueAxis), m_y(new QValueAxis) {
  m_scene.setItemIndexMethod(QGraphicsScene::NoIndex);
  m_scene.addItem(m_chart);
  m_chart->setLocalizeNumbers(true);
  m_chart->setLocale(axisLocale());
  m_chart->setMargins({});
  m_chart->layout()->setContentsMargins(0, 0, 0, 0);
  m_chart->setBackgroundRoundness(0);
  m_chart->legend()->hide();
  m_chart->addAxis(m_x, Qt::AlignBottom);
  m_chart->addAxis(m_y, Qt::AlignLeft);
  for (QValueAxis* axis : {m_x, m_y}) {
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0);
  }
  m_markers = new MarkerLayer(m_chart);
  m_markers->setZValue(100);
  m_legend = new Legend(m_chart);
  m_messageItem = new QGraphicsSimpleTextItem(m_chart);
  m_messageItem->setZValue(101);
}

Plot::~Plot() = default;

void Plot::addSeries(QAbstractSeries* series) {
  m_chart->addSeries(series);
  series->attachAxis(m_x);
  series->attachAxis(m_y);
}

void Plot::setTitles(const QString& x, const QString& y) {
  m_x->setTitleText(x);
  m_y->setTitleText(y);
}

void Plot::setStyle(const PlotStyle& style) {
  m_style = style;
  m_scene.setBackgroundBrush(style.background);
  m_chart->setBackgroundBrush(style.background);
  m_chart->setBackgroundPen(Qt::NoPen);
  m_chart->setPlotAreaBackgroundVisible(false);
  styleAxis(m_x);
  styleAxis(m_y);
  m_legend->setStyle(style);
  m_messageItem->setFont(style.font);
  m_messageItem->setBrush(style.mutedText);
  m_markers->setHighlightPen(QPen(style.text, 1.4 * style.unit()));
  applyStyle();
  rearrange();
}

void Plot::styleAxis(QValueAxis* axis) const {
  axis->setLabelsFont(m_style.font);
  axis->setTitleFont(m_style.font);
  axis->setLabelsBrush(m_style.text);
  axis->setTitleBrush(m_style.text);
  axis->setLinePen(QPen(m_style.frame, m_style.unit()));
  axis->setGridLinePen(QPen(m_style.grid, 0.8 * m_style.unit()));
}

void Plot::setHighlighted(std::optional<SightingRef> ref) {
  m_markers->setHighlighted(ref);
}

void Plot::setMessage(const QString& message) {
  m_message = message;
  m_messageItem->setText(message);
  m_messageItem->setVisible(!message.isEmpty());
  for (QValueAxis* axis : {m_x, m_y}) axis->setGridLineVisible(message.isEmpty());
}

void Plot::arrange(const QSizeF& size) {
  m_size = size;
  rearrange();
}

void Plot::rearrange() {
  if (m_size.isEmpty() || m_style.font.pixelSize() <= 0) return;
  const double pad = QFontMetricsF(m_style.font).height() * 0.5;
  m_scene.setSceneRect(QRectF({}, m_size));
  m_legend->setPos(pad, pad);
  const double legendHeight = m_legend->layOut(m_size.width() - 2 * pad);
  m_chart->setMargins(QMarginsF(pad, pad + legendHeight, pad, pad).toMargins());
  m_chart->resize(m_size);
  fitRangeToPlotArea();
  m_messageItem->setPos(m_plotArea.center() - m_messageItem->boundingRect().center());
  placeExtras();
}

void Plot::fitRangeToPlotArea() {
  // The range follows from the plot area, the widths of the labels from the range, and the plot area from
  // these.
  constexpr int passes = 4;
  for (int pass = 0; pass < passes; ++pass) {
    m_chart->layout()->activate();
    const QRectF area = m_chart->plotArea();
    if (area.width() < 1 || area.height() < 1 || (pass > 0 && area == m_plotArea)) return;
    m_plotArea = area;
    applyRange(axisRange(area.size()));
  }
}

void Plot::applyRange(const QRectF& range) {
  QTransform transform;
  transform.translate(m_plotArea.left(), m_plotArea.bottom());
  transform.scale(m_plotArea.width() / range.width(), -m_plotArea.height() / range.height());
  transform.translate(-range.left(), -range.top());
  m_sceneFromAxes = transform;
  const QFontMetricsF metrics(m_style.font);
  const double furthest = std::max({std::abs(range.left()), std::abs(range.right()), 1.0});
  const double xSpacing = metrics.horizontalAdvance(numberText(-furthest, 0)) * 1.35;
  const double ySpacing = metrics.height() * 2.6;
  double xStep = roundUp125(range.width() * xSpacing / m_plotArea.width());
  double yStep = roundUp125(range.height() * ySpacing / m_plotArea.height());
  if (hasEqualScales()) xStep = yStep = std::max(xStep, yStep);
  applyTicks(m_x, xStep);
  applyTicks(m_y, yStep);
  m_x->setRange(range.left(), range.right());
  m_y->setRange(range.top(), range.bottom());
  m_markers->setFrame(m_plotArea, m_sceneFromAxes);
}

void Plot::applyTicks(QValueAxis* axis, double step) const {
  // Each change of an axis lays all its labels out anew, even to the same format.
  const QString format = QStringLiteral("%.%1f").arg(decimalsOfStep(step));
  if (format != axis->labelFormat()) axis->setLabelFormat(format);
  // Narrow first: the old range over a much finer step would be thousands of ticks.
  if (step < axis->tickInterval()) axis->setRange(-step, step);
  axis->setTickInterval(step);
}

const Mark* Plot::markAt(const QPointF& scene) const {
  return m_plotArea.contains(scene) ? m_markers->markNear(scene, markReach * m_style.unit()) : nullptr;
}

}  // namespace alidade::ui
