#include "ui/charts/history/history_plot.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "core/exchange/csv_text.h"
#include "core/series/history/history_date.h"
#include "core/wording/verdict.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

// The lines in painting order.
enum Line {
  Tolerance,
  StatedLimit,
  SeenLimit,
  EwmaLimit,
  Ewma,
  BaselineEnd,
  Level,
  StepDate,
  Bar,
  LineCount
};
enum Kind { Usual, Outside };

double yearOfDay(double day) {
  return 2000 + day / daysPerYear;
}

}  // namespace

HistoryPlot::HistoryPlot(QObject* parent) : Plot(parent, true) {
  setHistory({}, {}, {});
}

void HistoryPlot::setHistory(const History& history, const QString& quantity, const std::string& unit) {
  m_history = history;
  m_quantity = quantity;
  m_unit = unit;
  m_scale = history.values.empty() ? 1 : HistoryNumbers(history, unit).scale();
  const QString heading = history.values.empty() ? QString() : qText(HistoryNumbers(history, unit).heading());
  setTitles(tr("date"), heading.isEmpty() ? quantity : tr("%1 (%2)").arg(quantity, heading));
  showWhole();
  draw();
}

double HistoryPlot::yearOf(const DatedValue& value) const {
  return yearOfDay(value.day);
}

bool HistoryPlot::hasBaseline() const {
  return m_history.chart.baseline < m_history.values.size();
}

std::vector<Plot::Tick> HistoryPlot::xTicks(double low, double high, std::size_t most) const {
  std::vector<Tick> ticks;
  if (m_history.values.empty()) return ticks;
  for (const DateTick& tick : dateTicks((low - 2000) * daysPerYear, (high - 2000) * daysPerYear, most))
    ticks.push_back({yearOfDay(tick.day), qText(tick.label)});
  return ticks;
}

void HistoryPlot::draw() {
  m_sticks.clear();
  std::vector<Mark> marks;
  const auto y = [&](double value) { return value * m_scale; };
  const auto add = [&](Line line, double x1, double y1, double x2, double y2) {
    m_sticks.push_back({QLineF(x1, y(y1), x2, y(y2)), static_cast<std::size_t>(line), {}});
  };
  const double centre = m_history.chart.centre;
  for (std::size_t i = 0; i < m_history.values.size(); ++i) {
    const DatedValue& value = m_history.values[i];
    const ControlChart::Point& point = m_history.chart.points[i];
    const double x = yearOf(value);
    marks.push_back({{x, y(value.value)}, point.isOut ? Outside : Usual, {0, i}, i, {}});
    add(Bar, x, value.value - value.expanded, x, value.value + value.expanded);
    if (i == 0) continue;
    const double before = yearOf(m_history.values[i - 1]);
    const ControlChart::Point& last = m_history.chart.points[i - 1];
    for (const double side : {-1.0, 1.0}) {
      add(StatedLimit, before, centre + side * last.shewhart, x, centre + side * point.shewhart);
      if (i == m_history.chart.baseline) continue;  // the average restarts here
      add(EwmaLimit, before, centre + side * last.ewmaLimit, x, centre + side * point.ewmaLimit);
    }
    if (i != m_history.chart.baseline) add(Ewma, before, last.ewma, x, point.ewma);
  }
  for (const Label& label : m_labels) delete label.item;
  m_labels.clear();
  reckonExtent();
  drawLevels();
  drawTolerance();
  setMessage(marks.empty() ? tr("Add sessions of a device, with the dates they were measured on.")
                           : QString());
  showMarks(std::move(marks), m_sticks);
  applyStyle();
  rearrange();
}

void HistoryPlot::label(double year, const QString& text) {
  m_labels.push_back({year, new QGraphicsSimpleTextItem(text, chart())});
}

/// Draws the tolerance if it is near the values; otherwise only the legend states the tolerance.
void HistoryPlot::drawTolerance() {
  if (!m_history.tolerance) return;
  for (const double side : {-1.0, 1.0}) {
    const double y = side * *m_history.tolerance * m_scale;
    if (y > m_extent.top() && y < m_extent.bottom())
      m_sticks.push_back({QLineF(m_extent.left(), y, m_extent.right(), y), Tolerance, {}});
  }
}

void HistoryPlot::drawLevels() {
  if (m_history.values.empty()) return;
  const auto add = [&](Line line, double x1, double y1, double x2, double y2) {
    m_sticks.push_back({QLineF(x1, y1 * m_scale, x2, y2 * m_scale), static_cast<std::size_t>(line), {}});
  };
  const double first = yearOf(m_history.values.front()), last = yearOf(m_history.values.back());
  const double centre = m_history.chart.centre;
  if (m_history.values.size() > 1 && std::isfinite(m_history.chart.seenSigma))
    for (const double side : {-1.0, 1.0}) {
      const double limit = centre + side * limitSigmas * m_history.chart.seenSigma;
      add(SeenLimit, first, limit, last, limit);
    }
  if (hasBaseline()) {
    const std::size_t end = m_history.chart.baseline;
    const double middle = (yearOf(m_history.values[end - 1]) + yearOf(m_history.values[end])) / 2;
    add(Level, first, centre, last, centre);
    m_sticks.push_back({QLineF(middle, m_extent.top(), middle, m_extent.bottom()), BaselineEnd, {}});
    label((first + middle) / 2, tr("baseline"));
    return;
  }
  if (m_history.course == Course::Trend && m_history.trend) {
    const auto at = [&](double year) {
      return m_history.trend->atMean +
             m_history.trend->perYear * (year - 2000 - m_history.trend->meanDay / daysPerYear);
    };
    add(Level, first, at(first), last, at(last));
    return;
  }
  double begin = first;
  for (std::size_t i = 0; i < m_history.steps.size(); ++i) {
    const HistoryStep& step = m_history.steps[i];
    const double middle =
        (yearOf(m_history.values[step.first - 1]) + yearOf(m_history.values[step.first])) / 2;
    add(Level, begin, m_history.levels[i], middle, m_history.levels[i]);
    add(StepDate, middle, m_history.levels[i], middle, m_history.levels[i + 1]);
    label(middle, visibleLine(step.date));
    begin = middle;
  }
  const double level = m_history.steps.empty() ? centre : m_history.levels.back();
  add(Level, begin, level, last, level);
}

void HistoryPlot::reckonExtent() {
  if (m_history.values.empty()) {
    m_extent = QRectF(0, -1, 1, 2);
    return;
  }
  double low = m_history.chart.centre, high = low;
  const auto include = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const DatedValue& value : m_history.values)
    for (const double side : {-1.0, 1.0}) include(value.value + side * value.expanded);
  // Limits must be visible, except the limits of a very uncertain value; also a tolerance near the values.
  const double reach = high - low;
  for (const ControlChart::Point& point : m_history.chart.points)
    for (const double side : {-1.0, 1.0})
      if (point.shewhart < reach) include(m_history.chart.centre + side * point.shewhart);
  if (const auto& tolerance = m_history.tolerance)
    for (const double limit : {-*tolerance, *tolerance})
      if (limit > low - reach && limit < high + reach) include(limit);
  const double first = yearOf(m_history.values.front()), last = yearOf(m_history.values.back());
  const double beside = std::max(0.04 * (last - first), last > first ? 0.0 : 0.5);
  const double above = 0.14 * (high - low), below = 0.06 * (high - low);  // room for the dates of steps
  m_extent = QRectF(first - beside, (low - below) * m_scale, last - first + 2 * beside,
                    (high - low + above + below) * m_scale);
}

void HistoryPlot::showLegend() {
  std::vector<LegendEntry> entries;
  if (!m_history.values.empty()) {
    const double unit = style().unit();
    const auto pen = [&](const QColor& colour, double width, Qt::PenStyle line) {
      return QPen(colour, width * unit, line);
    };
    entries.push_back({style().marker(0, MarkerShape::Circle),
                       tr("value ± U (%1)").arg(qText(shortProbabilityText(m_history.coverage)))});
    if (std::ranges::any_of(m_history.chart.points, &ControlChart::Point::isOut))
      entries.push_back({style().marker(180, MarkerShape::Diamond), tr("outside its limits")});
    const QString level = hasBaseline()                       ? tr("centre line")
                          : m_history.course == Course::Trend ? tr("trend")
                          : m_history.course == Course::Steps ? tr("levels")
                                                              : tr("mean");
    entries.push_back({pen(style().upper, 1.6, Qt::SolidLine), level});
    if (m_history.values.size() > 1) {
      entries.push_back({pen(style().limit, 1.2, Qt::DashLine), tr("limits (3 u)")});
      if (std::isfinite(m_history.chart.seenSigma))
        entries.push_back({pen(style().limit, 1.2, Qt::DotLine), tr("± 3 σ, observed")});
      entries.push_back({pen(style().lower, 1.2, Qt::SolidLine), tr("average (EWMA)")});
      entries.push_back({pen(style().lower, 1.0, Qt::DotLine), tr("EWMA limits")});
    }
    if (m_history.tolerance)
      entries.push_back(
          {pen(style().limit, 2.0, Qt::SolidLine),
           tr("tolerance ± %1").arg(qText(HistoryNumbers(m_history, m_unit).exact(*m_history.tolerance)))});
  }
  legendItem().setEntries(std::move(entries));
}

void HistoryPlot::applyStyle() {
  const double unit = style().unit();
  std::vector<QPen> pens(LineCount);
  pens[Tolerance] = QPen(style().limit, 2.0 * unit);
  pens[BaselineEnd] = QPen(style().mutedText, 1.0 * unit, Qt::DashDotLine);
  pens[StatedLimit] = QPen(style().limit, 1.2 * unit, Qt::DashLine);
  pens[SeenLimit] = QPen(style().limit, 1.2 * unit, Qt::DotLine);
  pens[EwmaLimit] = QPen(style().lower, 1.0 * unit, Qt::DotLine);
  pens[Ewma] = QPen(style().lower, 1.2 * unit);
  pens[Level] = QPen(style().upper, 1.6 * unit);
  pens[StepDate] = QPen(style().upper, 1.6 * unit, Qt::DashLine);
  pens[Bar] = QPen(style().text, 1.0 * unit);
  markerLayer().setPens(std::move(pens));
  markerLayer().setMarkers(
      {style().marker(0, MarkerShape::Circle), style().marker(180, MarkerShape::Diamond)});
  for (const Label& label : m_labels) {
    label.item->setFont(style().font);
    label.item->setBrush(style().text);
  }
  showLegend();
}

QRectF HistoryPlot::axisRange(const QSizeF&) const {
  return m_extent;
}

/// Each label is at the top, above its date; a label that overlaps the previous label moves down a line.
void HistoryPlot::placeExtras() {
  double rightmost = plotArea().left(), line = 0;
  for (const Label& label : m_labels) {
    const QRectF box = label.item->boundingRect();
    const double x = sceneFromAxes().map(QPointF(label.year, 0)).x() - box.width() / 2;
    line = x < rightmost ? line + 1 : 0;
    label.item->setPos(x, plotArea().top() + 2 + line * box.height());
    label.item->setVisible(x >= plotArea().left() && x + box.width() <= plotArea().right());
    rightmost = x + box.width();
  }
}

QString HistoryPlot::describe(const Mark& mark) const {
  if (mark.index >= m_history.values.size()) return {};
  const DatedValue& value = m_history.values[mark.index];
  const HistoryNumbers numbers(m_history, m_unit);
  QStringList lines{
      value.of.empty() ? visibleLine(value.date)
                       : tr("%1: %2").arg(visibleLine(value.date), visibleLine(value.of)),
      tr("%1 ± %2").arg(qText(numbers.withUnit(value.value)), qText(numbers.withUnit(value.expanded)))};
  const ControlChart::Point& point = m_history.chart.points[mark.index];
  lines.append(tr("%1 from the centre line, limits ± %2%3")
                   .arg(qText(numbers.withUnit(value.value - m_history.chart.centre)),
                        qText(numbers.withUnit(point.shewhart)), point.isOut ? tr(": outside") : QString()));
  for (const HistoryStep& step : m_history.steps)
    if (step.first == mark.index)
      lines.append(tr("the first value after a step of %1")
                       .arg(qText(numbers.withUncertainty(step.size, step.expanded))));
  if (m_history.oddValue == mark.index) lines.append(tr("an outlier"));
  for (const std::string* judged : {&value.judgement.verdict, &value.judgement.condition})
    if (!judged->empty()) lines.append(qText(*judged));
  return lines.join(u'\n');
}

QString HistoryPlot::summary() const {
  if (!message().isEmpty()) return message();
  return tr("%1, %2 values, from %3 to %4: %5")
      .arg(m_quantity)
      .arg(m_history.values.size())
      .arg(visibleLine(m_history.values.front().date), visibleLine(m_history.values.back().date),
           qText(courseName(m_history.course)));
}

QString HistoryPlot::standard() const {
  return tr(
      "Should be: the values scatter about one level within their limits, and the average stays within its "
      "own.");
}

std::string HistoryPlot::csv() const {
  const std::string unit = m_unit.empty() ? "" : "_" + m_unit;
  CsvText csv{"date",           "year",
              "value" + unit,   "u" + unit,
              "u_apart" + unit, "expanded_uncertainty" + unit,
              "centre" + unit,  "limit_3u" + unit,
              "ewma" + unit,    "ewma_limit" + unit,
              "outside",        "session",
              "verdict",        "condition"};
  for (std::size_t i = 0; i < m_history.values.size(); ++i) {
    const DatedValue& value = m_history.values[i];
    const ControlChart::Point& point = m_history.chart.points[i];
    csv.typed(value.date).number(yearOf(value)).number(value.value).number(value.u).number(value.apart);
    csv.number(value.expanded)
        .number(m_history.chart.centre)
        .number(point.shewhart)
        .number(point.ewma)
        .number(point.ewmaLimit)
        .count(point.isOut ? 1 : 0);
    csv.typed(value.of).typed(value.judgement.verdict).typed(value.judgement.condition).endRow();
  }
  return csv.text();
}

}  // namespace alidade::ui
