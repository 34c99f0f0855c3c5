#include "ui/charts/plot.h"

#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/charts/round_numbers.h"

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
}

void Plot::arrange(const QSizeF& size) {
  m_size = size;
  rearrange();
}

double Plot::leftMargin() const {
  const QFontMetricsF metrics(m_style.font);
  return metrics.height() * 1.9 + metrics.horizontalAdvance(QStringLiteral("−0000"));
}

void Plot::rearrange() {
  if (m_size.isEmpty() || m_style.font.pixelSize() <= 0) return;
  const QFontMetricsF metrics(m_style.font);
  const double pad = metrics.height() * 0.5;
  m_scene.setSceneRect(QRectF({}, m_size));
  m_chart->resize(m_size);
  m_legend->setPos(pad, pad);
  const double legendHeight = m_legend->layOut(m_size.width() - 2 * pad);
  const double top = legendHeight > 0 ? legendHeight + 1.6 * pad : pad;
  m_plotArea = QRectF(QPointF(leftMargin(), top),
                      QPointF(m_size.width() - 2 * pad, m_size.height() - metrics.height() * 2.9));
  if (m_plotArea.width() < 10 || m_plotArea.height() < 10) return;
  m_chart->setPlotArea(m_plotArea);
  applyRange(axisRange(m_plotArea.size()));
  m_messageItem->setPos(m_plotArea.center() - m_messageItem->boundingRect().center());
  placeExtras();
}

void Plot::applyRange(const QRectF& range) {
  QTransform transform;
  transform.translate(m_plotArea.left(), m_plotArea.bottom());
  transform.scale(m_plotArea.width() / range.width(), -m_plotArea.height() / range.height());
  transform.translate(-range.left(), -range.top());
  m_sceneFromAxes = transform;
  const QFontMetricsF metrics(m_style.font);
  applyTicks(m_x, range.width(), m_plotArea.width(),
             metrics.horizontalAdvance(QStringLiteral("−00000")) * 1.3);
  applyTicks(m_y, range.height(), m_plotArea.height(), metrics.height() * 2.2);
  m_x->setRange(range.left(), range.right());
  m_y->setRange(range.top(), range.bottom());
  m_markers->setFrame(m_plotArea, m_sceneFromAxes);
}

void Plot::applyTicks(QValueAxis* axis, double span, double pixels, double spacing) const {
  const double step = roundUp125(span * spacing / pixels);
  axis->setLabelFormat(QStringLiteral("%.%1f").arg(decimalsOfStep(step)));
  // Widen first: an old range over a fine new step would be thousands of ticks.
  if (step < axis->tickInterval()) axis->setRange(-step, step);
  axis->setTickInterval(step);
}

const Mark* Plot::markAt(const QPointF& scene) const {
  return m_plotArea.contains(scene) ? m_markers->markNear(scene, markReach * m_style.unit()) : nullptr;
}

}  // namespace alidade::ui
