#include "ui/charts/gap/form_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exchange/csv_text.h"
#include "core/wording/form_sentence.h"
#include "ui/charts/plotting/clipping.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

constexpr double halfLevel = 0.5;

/// The name of a sighting of the session.
QString sightingName(const Gap& gap, const FormPoint& point) {
  for (const ArcMeasurement& arc : gap.evaluation->examined.measurement->arcs)
    for (const Sighting& row : arc.sightings)
      if (arc.position == point.position && row.row == point.row)
        return sightingText(arc.axisDeg, arc.repeat, row.point, row.round, row.face);
  return {};
}

QString argumentTitle(FormArgument of) {
  switch (of) {
    case FormArgument::S:
      return FormPlot::tr("slider coordinate s (°)");
    case FormArgument::T:
      return FormPlot::tr("t, elapsed share of the session");
    case FormArgument::Azimuth:
      return FormPlot::tr("azimuth a (°), right positive");
    case FormArgument::Elevation:
      return FormPlot::tr("elevation e (°), up positive");
    case FormArgument::HorizontalCircle:
      return FormPlot::tr("horizontal circle α (°)");
    case FormArgument::VerticalCircle:
      return FormPlot::tr("vertical circle β (°)");
    case FormArgument::Leg:
      return FormPlot::tr("1: way there, −1: way back");
    case FormArgument::Face:
      return FormPlot::tr("1: face 1, −1: face 2");
    case FormArgument::Round:
      return FormPlot::tr("round");
    case FormArgument::Position:
      break;
  }
  return FormPlot::tr("1: axis at 0°, −1: at 180°");
}

}  // namespace

FormPlot::FormPlot(QObject* parent) : Plot(parent) {
  for (Band& band : m_bands) {
    band = {new QLineSeries(this), new QLineSeries(this), nullptr};
    band.area = new QAreaSeries(band.top, band.bottom);
    addSeries(band.area);
  }
  const auto addLine = [this] {
    auto* line = new QLineSeries;
    addSeries(line);
    return line;
  };
  m_zero = addLine();
  for (QLineSeries*& limit : m_limits) limit = addLine();
  for (auto& curve : m_curves)
    for (QLineSeries*& piece : curve) piece = addLine();
  draw();
}

void FormPlot::setForm(const Gap& gap, std::size_t index) {
  m_form = gap.diagnosis->forms[index];
  m_names.clear();
  for (const FormPoint& point : m_form.trace.points) m_names.push_back(sightingName(gap, point));
  showTitles();
  showWhole();
  draw();
}

bool FormPlot::isHeldOut() const {
  return std::ranges::any_of(m_form.trace.points,
                             [](const FormPoint& point) { return std::isfinite(point.heldOut); });
}

void FormPlot::showTitles() {
  setTitles(argumentTitle(m_form.form.of),
            //: %1: what a form displaces, %2: unit
            tr("%1 (%2)").arg(qText(carrierText(m_form.form)),
                              m_form.form.isMillimetres() ? QStringLiteral("mm") : QString(QChar(0x2033))));
}

void FormPlot::draw() {
  std::vector<Mark> marks;
  const bool isHeldOut = this->isHeldOut();
  for (std::size_t i = 0; i < m_form.trace.points.size(); ++i) {
    const FormPoint& point = m_form.trace.points[i];
    // The points of one level are drawn side by side.
    const double shift = hasLevels() ? (static_cast<double>(i % 25) - 12) * 2 * style().unit() : 0;
    const auto add = [&](double y, Kind kind) {
      if (std::isfinite(y))
        marks.push_back({{point.at, y}, kind, {point.position, point.row}, i, {shift, 0}});
    };
    add(point.before, point.isVertical ? BeforeVertical : Before);
    add(isHeldOut ? point.heldOut : point.after, point.isVertical ? AfterVertical : After);
  }
  setMessage(marks.empty() ? tr("No single sighting shows this form clearly.") : QString());
  showMarks(std::move(marks));
  reckonExtent();
  applyStyle();
  rearrange();
}

void FormPlot::reckonExtent() {
  double left = std::numeric_limits<double>::infinity(), right = -left, low = -m_form.trace.sigma,
         high = m_form.trace.sigma;
  const auto include = [&](double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    low = std::min(low, y);
    high = std::max(high, y);
  };
  for (const Mark& mark : markers().marks()) include(mark.at.x(), mark.at.y());
  for (const auto& [x, first, second] : m_form.trace.curve) {
    include(x, first);
    include(x, second);
  }
  if (!(left < right) || !std::isfinite(low) || !(low < high)) return void(m_extent = {0, -1, 1, 2});
  const double beside = hasLevels() ? 1 : 0.03 * (right - left), above = 0.07 * (high - low);
  m_extent = QRectF(QPointF(left - beside, low - above), QPointF(right + beside, high + above));
}

/// The curves of a circle. `which`: 0 for the horizontal or only carrier, 1 for the vertical circle.
QList<QList<QPointF>> FormPlot::curves(std::size_t which) const {
  const auto& curve = m_form.trace.curve;
  if (curve.empty() || (which == 1 && !hasTwoCircles())) return {};
  if (hasLevels()) {
    const auto level = [](const std::array<double, 3>& at) {
      return QList<QPointF>{{at[0] - halfLevel, at[1]}, {at[0] + halfLevel, at[1]}};
    };
    return {level(curve.front()), level(curve.back())};
  }
  QList<QPointF> line;
  for (const std::array<double, 3>& at : curve) line.append({at[0], at[1 + which]});
  return {line};
}

void FormPlot::placeExtras() {
  const QRectF range = sceneFromAxes().inverted().mapRect(plotArea());
  const auto level = [&](double y) { return QList<QPointF>{{range.left(), y}, {range.right(), y}}; };
  const auto show = [&](QLineSeries& line, double y) {
    line.replace(level(y));
    line.setVisible(range.top() <= y && y <= range.bottom() && !markers().marks().empty());
  };
  show(*m_zero, 0);
  show(*m_limits[0], m_form.trace.sigma);
  show(*m_limits[1], -m_form.trace.sigma);
  for (std::size_t which = 0; which < m_curves.size(); ++which) {
    QList<QList<QPointF>> pieces;
    for (const QList<QPointF>& line : curves(which)) pieces += clipped(line, range);
    for (std::size_t piece = 0; piece < mostPieces; ++piece)
      m_curves[which][piece]->replace(pieces.value(static_cast<qsizetype>(piece)));
  }
  for (std::size_t i = 0; i < mostBands; ++i) {
    const bool isThere = i < m_form.cleanRange.size();
    const double from = isThere ? std::clamp(m_form.cleanRange[i][0], range.left(), range.right()) : 0;
    const double to = isThere ? std::clamp(m_form.cleanRange[i][1], range.left(), range.right()) : 0;
    m_bands[i].top->replace(QList<QPointF>{{from, range.bottom()}, {to, range.bottom()}});
    m_bands[i].bottom->replace(QList<QPointF>{{from, range.top()}, {to, range.top()}});
    m_bands[i].area->setVisible(from < to);
  }
}

Marker FormPlot::markerOf(Kind kind) const {
  const bool isVertical = kind == BeforeVertical || kind == AfterVertical;
  return {.shape = isVertical ? MarkerShape::Diamond : MarkerShape::Circle,
          .colour = isVertical ? style().lower : style().upper,
          .inside = style().background,
          .filled = kind == After || kind == AfterVertical,
          .size = (kind == After || kind == AfterVertical ? 4.5 : 7) * style().unit()};
}

void FormPlot::applyStyle() {
  const double unit = style().unit();
  m_zero->setPen(QPen(style().frame, 0.8 * unit));
  for (QLineSeries* limit : m_limits) limit->setPen(QPen(style().limit, 1.2 * unit, Qt::DashLine));
  for (std::size_t which = 0; which < m_curves.size(); ++which)
    for (QLineSeries* piece : m_curves[which])
      piece->setPen(QPen(which == 0 ? style().upper : style().lower, 2 * unit));
  for (Band& band : m_bands) {
    band.area->setPen(Qt::NoPen);
    band.area->setBrush(style().outerBand);
  }
  std::vector<Marker> drawn;
  for (const Kind kind : {Before, After, BeforeVertical, AfterVertical}) drawn.push_back(markerOf(kind));
  markerLayer().setMarkers(std::move(drawn));
  showLegend();
}

void FormPlot::showLegend() {
  if (markers().marks().empty()) return legendItem().setEntries({});
  const double unit = style().unit();
  const QString after = isHeldOut() ? tr("after, held out") : tr("after");
  std::vector<LegendEntry> entries;
  if (hasTwoCircles()) {
    entries = {{QPen(style().upper, 2 * unit), tr("horizontal")},
               {QPen(style().lower, 2 * unit), tr("vertical")}};
  } else {
    entries = {{QPen(style().upper, 2 * unit), tr("the form")}};
  }
  entries.push_back({markerOf(Before), tr("before")});
  entries.push_back({markerOf(After), after});
  entries.push_back({QPen(style().limit, 1.2 * unit, Qt::DashLine), tr("±σ of a sighting")});
  if (!m_form.cleanRange.empty()) entries.push_back({style().outerBand, tr("the model holds")});
  legendItem().setEntries(std::move(entries));
}

QRectF FormPlot::axisRange(const QSizeF&) const {
  return m_extent;
}

QString FormPlot::valueText(double value) const {
  return m_form.form.isMillimetres() ? signedNumberText(value, 3) + QStringLiteral(" mm")
                                     : signedNumberText(value, 1) + QChar(0x2033);
}

QString FormPlot::describe(const Mark& mark) const {
  if (mark.index >= m_form.trace.points.size()) return {};
  const FormPoint& point = m_form.trace.points[mark.index];
  QString text = m_names[mark.index] + u'\n' +
                 tr("before %1, after %2").arg(valueText(point.before), valueText(point.after));
  if (std::isfinite(point.heldOut)) text += tr(", held out %1").arg(valueText(point.heldOut));
  return text;
}

QString FormPlot::summary() const {
  if (!message().isEmpty()) return message();
  return qText(textOf(m_form));
}

QString FormPlot::standard() const {
  return tr("Should be: hollow marks along the curve, filled ones an even band about 0.");
}

std::string FormPlot::csv() const {
  CsvText csv{"sighting", "circle", "argument", "before", "after", "after_held_out", "unit"};
  for (std::size_t i = 0; i < m_form.trace.points.size(); ++i) {
    const FormPoint& point = m_form.trace.points[i];
    csv.typed(m_names[i].toStdString());
    csv.word(!hasTwoCircles() ? "" : point.isVertical ? "vertical" : "horizontal");
    csv.number(point.at).number(point.before).number(point.after).number(point.heldOut);
    csv.word(m_form.form.isMillimetres() ? "mm" : "arcsec").endRow();
  }
  return csv.text();
}

}  // namespace alidade::ui
