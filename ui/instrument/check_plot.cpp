#include "ui/instrument/check_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exchange/csv_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr std::size_t ofNone = std::numeric_limits<std::size_t>::max();
constexpr int kinds = 5, longestName = 40;

}  // namespace

CheckPlot::CheckPlot(QObject* parent) : Plot(parent), m_zero(new QLineSeries) {
  addSeries(m_zero);
  showTitles();
  draw();
}

void CheckPlot::setCheck(const SharedInstrument& check) {
  m_check = check;
  showWhole();
  draw();
}

void CheckPlot::setView(View view) {
  if (view == m_view) return;
  m_view = view;
  showTitles();
  showWhole();
  draw();
}

void CheckPlot::showTitles() {
  switch (m_view) {
    case View::Course:
      return setTitles(tr("round, one station after another"), tr("minus its mean (″)"));
    case View::Residuals:
      return setTitles(tr("round, one station after another"), tr("residual (″)"));
    case View::Distance:
      return setTitles(tr("distance (m)"), tr("collimation (″)"));
  }
}

void CheckPlot::add(Point point) {
  if (std::isfinite(point.x) && std::isfinite(point.y)) m_points.push_back(point);
}

/// Adds all values minus their station mean, on one axis; `orientation` has the mean subtracted already.
void CheckPlot::addCourse(const StationCheck& station, std::size_t before) {
  for (std::size_t j = 0; j < station.course.size(); ++j) {
    const RoundCourse& round = station.course[j];
    const auto x = static_cast<double>(before + j + 1);
    add({x, round.collimation - station.collimation.value, Kind::Collimation, &station, j, ofNone});
    add({x, round.index - station.index.value, Kind::Index, &station, j, ofNone});
    add({x, round.orientation, Kind::Orientation, &station, j, ofNone});
  }
}

void CheckPlot::addResiduals(const StationCheck& station, std::size_t before) {
  for (const PairResidual& residual : station.residuals) {
    // The targets of a round are side by side.
    const double beside =
        0.6 * ((static_cast<double>(residual.target) + 0.5) / static_cast<double>(station.targets) - 0.5);
    const double x = static_cast<double>(before + residual.round + 1) + beside;
    add({x, residual.direction, Kind::Direction, &station, residual.round, residual.target});
    add({x, residual.vertical, Kind::Zenith, &station, residual.round, residual.target});
  }
}

void CheckPlot::addDistances(const StationCheck& station) {
  for (std::size_t k = 0; k < station.perTarget.size(); ++k)
    if (const TargetMean& target = station.perTarget[k]; target.distanceM > 0)
      add({target.distanceM, target.collimation, Kind::Collimation, &station, ofNone, k});
}

void CheckPlot::draw() {
  m_points.clear();
  std::size_t rounds = 0;
  if (m_check && m_check->check)
    for (const StationCheck& station : m_check->check->stations) {
      if (m_view == View::Course) addCourse(station, rounds);
      if (m_view == View::Residuals) addResiduals(station, rounds);
      if (m_view == View::Distance) addDistances(station);
      rounds += station.course.size();
    }
  std::vector<Mark> marks;
  double left = m_points.empty() ? 1 : m_points.front().x, right = m_points.empty() ? 3 : left, reach = 0;
  double low = 0, high = 0;
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    const Point& point = m_points[i];
    const double shift =
        m_view == View::Course ? 4.0 * (static_cast<int>(point.kind) - 1) * style().unit() : 0;
    marks.push_back({{point.x, point.y}, static_cast<std::size_t>(point.kind), {}, i, {shift, 0}});
    left = std::min(left, point.x);
    right = std::max(right, point.x);
    low = std::min(low, point.y);
    high = std::max(high, point.y);
    reach = std::max(reach, std::abs(point.y));
  }
  if (!(reach > 0)) low = -(high = 1);
  const double beside = m_view == View::Distance ? std::max(0.05 * (right - left), 0.5) : 0.7;
  const double above = 0.1 * (high - low);
  m_extent =
      QRectF(QPointF(m_view == View::Distance ? std::max(0.0, left - beside) : left - beside, low - above),
             QPointF(right + beside, high + above));
  setMessage(!m_points.empty()          ? QString()
             : m_view == View::Distance ? tr("No distances are known.")
                                        : tr("No complete round yet."));
  showMarks(std::move(marks));
  applyStyle();
  rearrange();
}

QString CheckPlot::nameOf(Kind kind) const {
  switch (kind) {
    case Kind::Collimation:
      return tr("collimation c");
    case Kind::Index:
      return tr("index");
    case Kind::Orientation:
      return tr("orientation");
    case Kind::Direction:
      return tr("direction");
    case Kind::Zenith:
      return tr("zenith angle");
  }
  return {};
}

Marker CheckPlot::markerOf(Kind kind) const {
  const double size = 7 * style().unit();
  const auto make = [&](MarkerShape shape, const QColor& colour, bool filled) {
    return Marker{
        .shape = shape, .colour = colour, .inside = style().background, .filled = filled, .size = size};
  };
  switch (kind) {
    case Kind::Index:
      return make(MarkerShape::Diamond, style().lower, false);
    case Kind::Orientation:
      return make(MarkerShape::Square, style().text, false);
    case Kind::Zenith:
      return make(MarkerShape::Diamond, style().lower, false);
    case Kind::Collimation:
    case Kind::Direction:
      break;
  }
  return make(MarkerShape::Circle, style().upper, true);
}

void CheckPlot::applyStyle() {
  m_zero->setPen(QPen(style().frame, 0.8 * style().unit()));
  std::vector<Marker> drawn;
  for (int kind = 0; kind < kinds; ++kind) drawn.push_back(markerOf(static_cast<Kind>(kind)));
  markerLayer().setMarkers(std::move(drawn));
  showLegend();
}

void CheckPlot::showLegend() {
  std::vector<LegendEntry> entries;
  for (int i = 0; i < kinds; ++i) {
    const auto kind = static_cast<Kind>(i);
    const bool isDrawn = std::any_of(m_points.begin(), m_points.end(),
                                     [kind](const Point& point) { return point.kind == kind; });
    if (isDrawn) entries.push_back({markerOf(kind), nameOf(kind)});
  }
  legendItem().setEntries(std::move(entries));
}

QRectF CheckPlot::axisRange(const QSizeF&) const {
  return m_extent;
}

void CheckPlot::placeExtras() {
  const QRectF range = sceneFromAxes().inverted().mapRect(plotArea());
  const bool isSeen = range.top() <= 0 && range.bottom() >= 0;
  m_zero->replace(QList<QPointF>{{range.left(), 0}, {range.right(), 0}});
  m_zero->setVisible(isSeen && !m_points.empty());
}

QString CheckPlot::describe(const Mark& mark) const {
  if (mark.index >= m_points.size()) return {};
  const Point& point = m_points[mark.index];
  QStringList where{shortLine(point.station->station, longestName)};
  if (point.round != ofNone)
    where.append(tr("round %1").arg(shortLine(point.station->course[point.round].name, longestName)));
  if (point.target != ofNone)
    where.append(tr("target %1").arg(shortLine(point.station->perTarget[point.target].name, longestName)));
  if (m_view == View::Distance) where.append(numberText(point.x, 2) + QStringLiteral(" m"));
  return listText(where) + u'\n' +
         QStringLiteral("%1: %2″").arg(nameOf(point.kind), signedNumberText(point.y, 2));
}

QString CheckPlot::summary() const {
  if (!message().isEmpty()) return message();
  double largest = 0;
  for (const Point& point : m_points) largest = std::max(largest, std::abs(point.y));
  return tr("%1 points, at most %2").arg(m_points.size()).arg(arcsecText(largest));
}

QString CheckPlot::standard() const {
  switch (m_view) {
    case View::Course:
      return tr(
          "Should be: level from round to round. A slope shows a drift; a step shows that something moved.");
    case View::Residuals:
      return tr(
          "Should be: an even band about 0 in every round, and no target with residuals of one sign only.");
    case View::Distance:
      break;
  }
  return tr(
      "Should be: level. A rise towards short distances shows an offset e of the line of sight from the "
      "axis: it grows as e/D.");
}

std::string CheckPlot::csv() const {
  CsvText csv{"station", "round", "target", "value", m_view == View::Distance ? "distance_m" : "round_number",
              "arcsec"};
  const char* const names[kinds] = {"collimation", "index", "orientation", "direction_residual",
                                    "zenith_residual"};
  for (const Point& point : m_points) {
    csv.typed(point.station->station);
    csv.typed(point.round == ofNone ? std::string() : point.station->course[point.round].name);
    csv.typed(point.target == ofNone ? std::string() : point.station->perTarget[point.target].name);
    csv.word(names[static_cast<int>(point.kind)]);
    csv.number(m_view == View::Distance ? point.x : std::round(point.x)).number(point.y).endRow();
  }
  return csv.text();
}

}  // namespace alidade::ui
