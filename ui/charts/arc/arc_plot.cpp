#include "ui/charts/arc/arc_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exchange/csv_text.h"
#include "ui/charts/plotting/clipping.h"
#include "ui/charts/plotting/row_choice.h"
#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

/// The kinds of marks in face 1; those of face 2 follow in the same order.
enum Kind : std::size_t { Upper, Lower, UpperAgain, LowerAgain, Excluded };
constexpr std::size_t kindsOfAFace = Excluded + 1;

std::size_t arcIndex(int axisDeg) {
  return axisDeg == 0 ? Upper : Lower;
}

std::size_t kindOf(const DrawnSighting& sighting) {
  const bool isUpper = sighting.axisDeg == 0;
  const std::size_t ofFaceOne =
      sighting.repeat > 1 ? (isUpper ? UpperAgain : LowerAgain) : (isUpper ? Upper : Lower);
  return ofFaceOne + (sighting.face == 2 ? kindsOfAFace : 0);
}

/// A polyline that deviates from the circle by less than `sagitta` mm.
QList<QPointF> polyline(const DrawnArc& arc, double sagitta) {
  const double step = std::sqrt(8 * sagitta / arc.circle.radius);
  const double wanted = std::ceil((arc.lastAngle - arc.firstAngle) / step);
  const int steps = wanted > 60 ? static_cast<int>(std::min(wanted, 20000.0)) : 60;  // 60 also for NaN
  QList<QPointF> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = arc.firstAngle + (arc.lastAngle - arc.firstAngle) * i / steps;
    const auto [x, y] = targetOnArc(arc.circle.x, arc.circle.y, arc.circle.radius, angle);
    points.append({x, y});
  }
  return points;
}

}  // namespace

ArcPlot::ArcPlot(QObject* parent)
    : Plot(parent), m_inset(new CentresInset(chart())), m_side(new SideView(chart())) {
  for (auto& pieces : m_arcs)
    for (QLineSeries*& piece : pieces) addSeries(piece = new QLineSeries);
  m_inset->setZValue(90);
  m_side->setZValue(90);
}

/// In a narrow plot the title of the x axis names both axes.
void ArcPlot::adaptTo(const QSizeF& size) {
  const bool isNarrow = size.width() < 300 * style().unit();
  setTitles(isNarrow ? QStringLiteral("x, y (mm)") : QStringLiteral("x (mm)"),
            isNarrow ? QString() : QStringLiteral("y (mm)"));
}

void ArcPlot::setHeadline(const Headline& headline) {
  m_inset->setHeadline(headline);
  m_side->setOffset(headline.offset);
  placeViews();
}

void ArcPlot::setEvaluation(const Evaluation& evaluation) {
  m_picture = arcPictureOf(evaluation);
  m_extent = m_picture->extent();
  setMessage(m_picture->isEmpty() ? tr("No usable readings yet.") : QString());
  m_inset->setIntersection(m_picture->intersection);
  drawMarks();
  showLegend();
  rearrange();
}

void ArcPlot::setChoice(const RowChoice& choice) {
  if (choice == m_choice) return;
  m_choice = choice;
  drawMarks();
  showLegend();
  rearrange();
}

/// Draws the visible part of the arcs, exact to a tenth of a scene unit.
void ArcPlot::showArcs() {
  const QRectF range = sceneFromAxes().inverted().mapRect(plotArea());
  const double sagitta = 0.1 * range.width() / std::max(1.0, plotArea().width());
  std::array<QList<QList<QPointF>>, 2> pieces;
  for (const DrawnArc& arc : m_picture->arcs)
    pieces[arcIndex(arc.axisDeg)] = clipped(polyline(arc, sagitta), range);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t piece = 0; piece < mostPieces; ++piece)
      m_arcs[i][piece]->replace(pieces[i].value(static_cast<qsizetype>(piece)));
}

/// The shift of a mark along the arc, in scene units, which separates rounds and faces of one place.
QPointF ArcPlot::shiftOf(const DrawnSighting& sighting) const {
  const double shift = m_slots.shift(sighting.round, sighting.face) * style().unit();
  if (shift == 0) return {};
  const auto arc = std::ranges::find(m_picture->arcs, sighting.axisDeg, &DrawnArc::axisDeg);
  const Circle circle = arc == m_picture->arcs.end() ? Circle() : arc->circle;
  const double x = sighting.sighted.x - circle.x, y = sighting.sighted.y - circle.y;
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0)) return {0, -shift};
  return {-shift * y / length, -shift * x / length};
}

void ArcPlot::drawMarks() {
  m_drawn = m_choice.among(m_picture->kinds);
  m_slots = RowSlots(m_picture->kinds, m_drawn);
  m_unit = style().unit();
  std::vector<Mark> marks;
  std::vector<Stick> sticks;
  marks.reserve(m_picture->sightings.size() + m_picture->excluded.size());
  sticks.reserve(m_picture->sightings.size());
  for (std::size_t i = 0; i < m_picture->sightings.size(); ++i) {
    const DrawnSighting& sighting = m_picture->sightings[i];
    if (!isDrawn(sighting)) continue;
    const QPointF at(sighting.sighted.x, sighting.sighted.y), shift = shiftOf(sighting);
    marks.push_back({at, kindOf(sighting), sighting.ref, i, shift});
    if (!sighting.adjusted) continue;
    const PlanePoint<double> end = m_picture->residualEnd(sighting);
    sticks.push_back({QLineF(sighting.adjusted->x, sighting.adjusted->y, end.x, end.y),
                      arcIndex(sighting.axisDeg), shift});
  }
  for (std::size_t i = 0; i < m_picture->excluded.size(); ++i) {
    const DrawnSighting& sighting = m_picture->excluded[i];
    if (isDrawn(sighting))
      marks.push_back(
          {{sighting.sighted.x, sighting.sighted.y}, Excluded, sighting.ref, i, shiftOf(sighting)});
  }
  showMarks(std::move(marks), std::move(sticks));
}

void ArcPlot::showLegend() {
  std::vector<LegendEntry> entries;
  for (const int axisDeg : {0, 180}) {
    for (const int repeat : {1, 2}) {
      const bool any = std::any_of(
          m_picture->sightings.begin(), m_picture->sightings.end(), [&](const DrawnSighting& sighting) {
            return sighting.axisDeg == axisDeg && (sighting.repeat > 1) == (repeat > 1);
          });
      if (!any) continue;
      entries.push_back({style().marker(axisDeg, MarkerShape::Circle, repeat),
                         tr("arc at %1").arg(positionText(axisDeg, repeat))});
    }
  }
  if (!m_picture->excluded.empty()) entries.push_back({style().excludedMarker(), tr("excluded")});
  if (!m_picture->arcs.empty()) {
    entries.push_back({QPen(style().text, 1.4 * style().unit()),
                       tr("residuals %1").arg(exaggerationText(m_picture->exaggeration))});
  }
  for (LegendEntry& entry : rowEntries(style(), m_picture->kinds, m_drawn, m_slots.areApart()))
    entries.push_back(std::move(entry));
  legendItem().setEntries(std::move(entries));
}

void ArcPlot::applyStyle() {
  const double unit = style().unit();
  if (unit != m_unit) drawMarks();
  for (QLineSeries* piece : m_arcs[Upper]) piece->setPen(QPen(style().upper, 1.3 * unit));
  for (QLineSeries* piece : m_arcs[Lower]) piece->setPen(QPen(style().lower, 1.3 * unit, Qt::DashLine));
  std::vector<Marker> markers{style().marker(0, MarkerShape::Circle),
                              style().marker(180, MarkerShape::Circle),
                              style().marker(0, MarkerShape::Circle, 2),
                              style().marker(180, MarkerShape::Circle, 2), style().excludedMarker()};
  for (std::size_t kind = 0; kind < kindsOfAFace; ++kind) {
    markers.push_back(markers[kind]);
    markers.back().struck = kind != Excluded;
  }
  markerLayer().setMarkers(std::move(markers));
  markerLayer().setPens({QPen(style().upper, 1.4 * unit), QPen(style().lower, 1.4 * unit)});
  m_inset->setStyle(style());
  m_side->setStyle(style());
  showLegend();
}

QRectF ArcPlot::axisRange(const QSizeF& plotArea) const {
  QRectF extent = m_extent;
  if (extent.width() <= 0 && extent.height() <= 0) extent = QRectF(-500, -500, 1000, 1000);
  const double perUnit =
      1.08 * std::max(extent.width() / plotArea.width(), extent.height() / plotArea.height());
  QRectF range(QPointF(), plotArea * perUnit);
  range.moveCenter(extent.center());
  return range;
}

void ArcPlot::placeExtras() {
  showArcs();
  placeViews();
}

void ArcPlot::placeViews() {
  if (m_picture->intersection && !plotArea().isEmpty()) placeInset();
  placeSideView();
}

/// The side of the largest square in the lower right corner that keeps clear of points, residuals and arcs;
/// at most a third of the height.
double ArcPlot::cornerOfSideView() const {
  const QRectF area = plotArea();
  double side = area.height() / 3;
  const auto keepClearOf = [&](const QPointF& point) {
    side = std::min(side, std::max(area.right() - point.x(), area.bottom() - point.y()));
  };
  for (const DrawnSighting& sighting : m_picture->sightings)
    for (const PlanePoint<double>& end : {sighting.sighted, m_picture->residualEnd(sighting)})
      keepClearOf(sceneFromAxes().map(QPointF(end.x, end.y)));
  for (const auto& pieces : m_arcs)
    for (const QLineSeries* piece : pieces)
      for (const QPointF& point : piece->points()) keepClearOf(sceneFromAxes().map(point));
  return side;
}

/// Places the side view below the inset, which gives up part of its square. Returns false and changes nothing
/// if the plot is zoomed, the room is too small, or the headline of the inset no longer fits.
bool ArcPlot::placeSideViewBelowInset() {
  constexpr double leastInset = 12, shareOfInset = 0.52;  // `leastInset` in lines of text
  const QRectF inset = m_inset->boundingRect();
  if (isZoomed() || !m_side->isMeasured() ||
      inset.width() < leastInset * QFontMetricsF(style().font).height())
    return false;
  const bool hasHeadline = !m_inset->titleLines().isEmpty();
  const double height = shareOfInset * inset.height(), margin = 4 * style().unit();
  m_inset->setSquare({inset.left(), inset.top(), inset.width(), height});
  if (hasHeadline && m_inset->titleLines().isEmpty()) {
    m_inset->setSquare(inset);
    return false;
  }
  m_side->setSquare(inset.adjusted(0, height + margin, 0, 0));
  return true;
}

void ArcPlot::placeSideView() {
  if (!m_picture->intersection || plotArea().isEmpty()) return m_side->setSquare({});
  constexpr double enough = 10;  // lines of text
  const double margin = 4 * style().unit(), side = std::max(0.0, cornerOfSideView() - 2 * margin);
  if (side < enough * QFontMetricsF(style().font).height() && placeSideViewBelowInset()) return;
  const QRectF area = plotArea();
  m_side->setSquare({area.right() - margin - side, area.bottom() - margin - side, side, side});
}

void ArcPlot::placeInset() {
  // The largest square about the centres that keeps clear of points, residuals and scales.
  const PlanePoint<double> a = m_picture->intersection->upperCentre, b = m_picture->intersection->lowerCentre;
  const PlanePoint<double> centre{(a.x + b.x) / 2, (a.y + b.y) / 2};
  double reach = m_picture->arcs.front().circle.radius;
  for (const DrawnSighting& sighting : m_picture->sightings) {
    const PlanePoint<double> ends[] = {sighting.sighted, m_picture->residualEnd(sighting)};
    for (const PlanePoint<double>& point : ends) {
      reach = std::min(reach, std::max(std::abs(point.x - centre.x), std::abs(point.y - centre.y)));
    }
  }
  const QPointF middle = sceneFromAxes().map(QPointF(centre.x, centre.y));
  const QRectF area = plotArea();
  const double half = std::max(
      0.0, std::min({0.92 * reach * sceneFromAxes().m11(), middle.x() - area.left(),
                     area.right() - middle.x(), middle.y() - area.top(), area.bottom() - middle.y()}));
  QRectF square(0, 0, 2 * half, 2 * half);
  square.moveCenter(middle);
  if (isZoomed()) {  // fixed in the upper left corner while a part is enlarged
    const double margin = 4 * style().unit(), side = 0.42 * std::min(area.width(), area.height());
    square = QRectF(area.left() + margin, area.top() + margin, side, side);
  }
  m_inset->setSquare(square);
}

const DrawnSighting* ArcPlot::sightingOf(const Mark& mark) const {
  const auto& list = mark.kind == Excluded ? m_picture->excluded : m_picture->sightings;
  return mark.index < list.size() ? &list[mark.index] : nullptr;
}

QString ArcPlot::describe(const Mark& mark) const {
  const DrawnSighting* sighting = sightingOf(mark);
  if (!sighting) return {};
  QString text =
      sightingText(sighting->axisDeg, sighting->repeat, sighting->point, sighting->round, sighting->face) +
      QStringLiteral("\nx = %1, y = %2")
          .arg(lengthText(sighting->sighted.x, 3), lengthText(sighting->sighted.y, 3));
  if (sighting->adjusted) {
    const double off = std::hypot(sighting->residual.x, sighting->residual.y);
    text += u'\n' + tr("%1 from the adjusted point").arg(lengthText(off, 3));
  } else if (mark.kind == Excluded) {
    text += u'\n' + tr("excluded from the fit");
  }
  return text;
}

QString ArcPlot::tipAt(const QPointF& scene) const {
  const bool isInInset = m_inset->isVisible() && m_inset->contains(m_inset->mapFromScene(scene));
  return isInInset ? tipText(m_inset->cutWarning()) : QString();
}

QString ArcPlot::summary() const {
  if (m_picture->isEmpty()) return message();
  return tr("%1 sighted points, %2 fitted arcs, residuals drawn %3")
      .arg(m_picture->sightings.size())
      .arg(m_picture->arcs.size())
      .arg(exaggerationText(m_picture->exaggeration));
}

QString ArcPlot::standard() const {
  return m_picture->intersection && m_picture->intersection->tolerance
             ? tr("Should be: strokes point in all directions, O1 and O2 lie within the tolerance.")
             : tr("Should be: strokes point in all directions, O1 and O2 lie close to the axis.");
}

std::string ArcPlot::csv() const {
  CsvText csv{"axis_deg", "turn", "point",         "round",         "face",          "excluded",
              "x_mm",     "y_mm", "adjusted_x_mm", "adjusted_y_mm", "residual_x_mm", "residual_y_mm"};
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const Mark& mark : markers().marks()) {
    const DrawnSighting& sighting = *sightingOf(mark);
    const bool isAdjusted = sighting.adjusted.has_value();
    csv.count(sighting.axisDeg).count(sighting.repeat).count(sighting.point).count(sighting.round);
    csv.count(sighting.face).word(mark.kind == Excluded ? "yes" : "");
    csv.number(sighting.sighted.x).number(sighting.sighted.y);
    csv.number(isAdjusted ? sighting.sighted.x - sighting.residual.x : none)
        .number(isAdjusted ? sighting.sighted.y - sighting.residual.y : none);
    csv.number(isAdjusted ? sighting.residual.x : none)
        .number(isAdjusted ? sighting.residual.y : none)
        .endRow();
  }
  return csv.text();
}

}  // namespace alidade::ui
