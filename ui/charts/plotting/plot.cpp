#include "ui/charts/plotting/plot.h"

#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLocale>
#include <QPainter>
#include <QtCharts/QCategoryAxis>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/base/round_numbers.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

constexpr double linesForTitles = 8;  // least height below the legend, in lines of text
constexpr double aboveZero = 1e-9;    // shift of the ticks, as a share of their step
constexpr double leastLabels = 3;     // fewest labels of an axis
constexpr double markReach = 9;       // reach of a click, in units of `PlotStyle::unit`

/// Writes −12.5: a real minus sign and a decimal point, which no English locale combines.
QLocale axisLocale() {
  QLocale locale(QLocale::Romansh, QLocale::Switzerland);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

/// The next finer step of … 0.5, 1, 2, 4, 5, 10 …. For any a, one step has exactly 3 multiples in [−a, a].
double finerStep(double step) {
  const double below = roundDown125(0.9 * step);
  return below < 0.45 * step ? 2 * below : below;  // the step after 5 is 4
}

/// `step`, or the largest finer step with at least three multiples in the range.
double stepOfLabels(double step, double low, double high) {
  constexpr double slack = 1e-9;
  const auto labels = [&](double of) {
    return std::floor(high / of + slack) - std::ceil(low / of - slack) + 1;
  };
  while (labels(step) < leastLabels) step = finerStep(step);
  return step;
}

}  // namespace

Plot::Plot(QObject* parent, bool hasNamedX)
    : QObject(parent),
      m_chart(new QChart),
      m_x(hasNamedX ? new QCategoryAxis : new QValueAxis),
      m_y(new QValueAxis) {
  if (auto* named = qobject_cast<QCategoryAxis*>(m_x))
    named->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
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
  if (m_x->titleText() != x) m_x->setTitleText(x);
  if (m_y->titleText() != y) m_y->setTitleText(y);
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

void Plot::setCorner(double width) {
  if (width == m_corner) return;
  m_corner = width;
  rearrange();
}

void Plot::showMarks(std::vector<Mark> marks, std::vector<Stick> sticks) {
  std::optional<Mark> kept;
  if (const Mark* mark = current()) kept = *mark;
  markerLayer().setMarks(std::move(marks), std::move(sticks));
  m_alongX.clear();
  m_alongY.clear();
  if (!kept) return;
  const auto& now = m_markers->marks();
  const auto isSame = [&](const Mark& mark) { return mark.ref == kept->ref && mark.kind == kept->kind; };
  const auto found = std::ranges::find_if(now, isSame);
  if (found != now.end()) m_markers->setCurrent(static_cast<std::size_t>(found - now.begin()));
}

void Plot::zoom(double factor, const QPointF& about) {
  if (m_plotArea.isEmpty() || !(factor > 0)) return;
  const bool isBeside = about.x()<m_plotArea.left(), isBelow = about.y()> m_plotArea.bottom();
  const bool both = hasEqualScales() || isBeside == isBelow;
  const QSizeF factors(both || isBelow ? factor : 1, both || isBeside ? factor : 1);
  const QPointF at(std::clamp(about.x(), m_plotArea.left(), m_plotArea.right()),
                   std::clamp(about.y(), m_plotArea.top(), m_plotArea.bottom()));
  m_view.zoom(factors, m_sceneFromAxes.inverted().map(at), shownRange(), m_whole);
  rearrange();
}

void Plot::zoomTo(const QRectF& part) {
  if (part.isEmpty() || m_plotArea.isEmpty()) return;
  m_view.show(m_sceneFromAxes.inverted().mapRect(part & m_plotArea), m_whole);
  rearrange();
}

void Plot::move(const QPointF& by) {
  if (m_plotArea.isEmpty()) return;
  const QTransform axesFromScene = m_sceneFromAxes.inverted();
  m_view.move(axesFromScene.map(QPointF()) - axesFromScene.map(by), shownRange(), m_whole);
  rearrange();
}

void Plot::showWhole() {
  if (!isZoomed()) return;
  m_view.reset();
  rearrange();
}

QRectF Plot::shownRange() const {
  return m_sceneFromAxes.inverted().mapRect(m_plotArea);
}

const Mark* Plot::current() const {
  const auto index = m_markers->current();
  return index ? &m_markers->marks()[*index] : nullptr;
}

const std::vector<std::uint32_t>& Plot::orderAlong(bool isVertical) {
  std::vector<std::uint32_t>& order = isVertical ? m_alongY : m_alongX;
  const auto& marks = m_markers->marks();
  if (order.size() == marks.size()) return order;
  order.resize(marks.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) {
    const Mark& mark = marks[i];
    return isVertical ? std::tuple(mark.at.y(), mark.at.x(), 0.0)
                      : std::tuple(mark.at.x(), mark.shift.x(), mark.at.y());
  });
  return order;
}

const Mark* Plot::step(Step step) {
  const auto& marks = m_markers->marks();
  if (marks.empty()) return nullptr;
  const auto& order = orderAlong(step == Step::Up || step == Step::Down);
  const bool isOn = step == Step::Right || step == Step::Up;
  std::size_t next = isOn ? 0 : order.size() - 1;
  if (const auto index = m_markers->current()) {
    const auto at = static_cast<std::size_t>(std::ranges::find(order, *index) - order.begin());
    next = isOn ? std::min(at + 1, order.size() - 1) : at - std::min<std::size_t>(at, 1);
  } else if (const auto row = m_markers->highlighted()) {
    const auto found = std::ranges::find(order, *row, [&](std::uint32_t i) { return marks[i].ref; });
    if (found != order.end()) next = static_cast<std::size_t>(found - order.begin());
  }
  m_markers->setCurrent(order[next]);
  if (isZoomed()) {
    m_view.include(marks[order[next]].at, shownRange(), m_whole);
    rearrange();
  }
  return current();
}

void Plot::paint(QPainter* painter) {
  painter->setRenderHint(QPainter::Antialiasing);
  m_scene.render(painter, QRectF({}, m_size), QRectF({}, m_size));
}

void Plot::arrange(const QSizeF& size) {
  m_size = size;
  rearrange();
}

void Plot::rearrange() {
  if (m_size.isEmpty() || m_style.font.pixelSize() <= 0) return;
  adaptTo(m_size);
  const double pad = QFontMetricsF(m_style.font).height() * 0.5;
  m_scene.setSceneRect(QRectF({}, m_size));
  m_legend->setPos(pad, pad);
  double legendHeight = m_legend->layOut(m_size.width() - 2 * pad, m_corner);
  const bool hasTitles =
      m_size.height() - legendHeight - 2 * pad >= linesForTitles * QFontMetricsF(m_style.font).height();
  m_legend->setVisible(hasTitles);
  if (!hasTitles) legendHeight = 0;
  for (QValueAxis* axis : {m_x, m_y})
    if (axis->isTitleVisible() != hasTitles) axis->setTitleVisible(hasTitles);
  m_chart->setMargins(QMarginsF(pad, pad + legendHeight, pad, pad).toMargins());
  m_chart->resize(m_size);
  fitRangeToPlotArea();
  m_messageItem->setPos(m_plotArea.center() - m_messageItem->boundingRect().center());
  placeExtras();
}

void Plot::fitRangeToPlotArea() {
  // The range depends on the plot area, the label widths on the range, and the plot area on the label widths.
  constexpr int passes = 4;
  for (int pass = 0; pass < passes; ++pass) {
    m_chart->layout()->activate();
    const QRectF area = m_chart->plotArea();
    if (area.width() < 1 || area.height() < 1 || (pass > 0 && area == m_plotArea)) return;
    m_plotArea = area;
    m_whole = axisRange(area.size());
    applyRange(m_view.within(m_whole, hasEqualScales()));
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
  const auto stepFor = [&](int decimals) {
    const double spacing = metrics.horizontalAdvance(numberText(-furthest, decimals)) * 1.35;
    return roundUp125(range.width() * spacing / m_plotArea.width());
  };
  const double ySpacing = metrics.height() * 2.6;
  double xStep = stepFor(std::min(decimalsOfStep(stepFor(0)), 9));
  double yStep = roundUp125(range.height() * ySpacing / m_plotArea.height());
  if (hasEqualScales()) xStep = yStep = std::max(xStep, yStep);
  xStep = stepOfLabels(xStep, range.left(), range.right());
  yStep = stepOfLabels(yStep, range.top(), range.bottom());
  if (!isZoomed()) {
    xStep = std::max(xStep, leastXStep());
    yStep = std::max(yStep, leastYStep());
  }
  if (qobject_cast<QCategoryAxis*>(m_x))
    applyNames(range);
  else
    applyTicks(m_x, xStep);
  applyTicks(m_y, yStep);
  // Since `applyTicks` shifts the ticks, the raised upper limits keep a tick at the end inside.
  m_x->setRange(range.left(), range.right() + 2 * aboveZero * xStep);
  m_y->setRange(range.top(), range.bottom() + 2 * aboveZero * yStep);
  m_markers->setFrame(m_plotArea, m_sceneFromAxes);
}

/// If the widest label allows too few names, tries up to five more, which fit if they are short.
std::vector<Plot::Tick> Plot::namesFor(const QRectF& range) const {
  const QFontMetricsF metrics(m_style.font);
  const double width = 1.35 * metrics.horizontalAdvance(widestXLabel()), scale = m_sceneFromAxes.m11();
  auto most = static_cast<std::size_t>(std::max(1.0, m_plotArea.width() / std::max(1.0, width)));
  std::vector<Tick> ticks = xTicks(range.left(), range.right(), most);
  const auto haveRoom = [&](const std::vector<Tick>& names) {
    for (std::size_t i = 0; i + 1 < names.size(); ++i)
      if (scale * (names[i + 1].at - names[i].at) < 1.2 * metrics.horizontalAdvance(names[i].label))
        return false;
    return true;
  };
  for (const std::size_t few = most + 5; ticks.size() < leastLabels && most < few;) {
    std::vector<Tick> finer = xTicks(range.left(), range.right(), ++most);
    if (haveRoom(finer)) ticks = std::move(finer);
  }
  return ticks;
}

void Plot::applyNames(const QRectF& range) {
  auto* axis = qobject_cast<QCategoryAxis*>(m_x);
  const QStringList before = axis->categoriesLabels();
  for (const QString& label : before) axis->remove(label);
  axis->setStartValue(range.left());
  for (const Tick& tick : namesFor(range)) axis->append(tick.label, tick.at);
}

void Plot::applyTicks(QValueAxis* axis, double step) const {
  // Each change of an axis lays all its labels out again, even with the same format.
  const QString format = QStringLiteral("%.%1f").arg(decimalsOfStep(step));
  if (format != axis->labelFormat()) axis->setLabelFormat(format);
  // Narrows the range first: the old range with a much finer step has thousands of ticks.
  if (step < axis->tickInterval()) axis->setRange(-step, step);
  axis->setTickInterval(step);
  // Qt adds up the ticks: without the shift, three steps of 0.1 from −0.3 end below 0, written as −0.0.
  axis->setTickAnchor(aboveZero * step);
}

const Mark* Plot::markAt(const QPointF& scene) const {
  return m_plotArea.contains(scene) ? m_markers->markNear(scene, markReach * m_style.unit()) : nullptr;
}

}  // namespace alidade::ui
