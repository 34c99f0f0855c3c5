#include "ui/charts/arc/arc_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/text/position_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

enum Kind : std::size_t { Upper, Lower, UpperAgain, LowerAgain, Excluded };

std::size_t arcIndex(int axisDeg) {
  return axisDeg == 0 ? Upper : Lower;
}

std::size_t kindOf(const DrawnSighting& sighting) {
  const bool isUpper = sighting.axisDeg == 0;
  if (sighting.time > 1) return isUpper ? UpperAgain : LowerAgain;
  return isUpper ? Upper : Lower;
}

QList<QPointF> polyline(const DrawnArc& arc) {
  constexpr int steps = 240;  // deviates from the circle by less than 1/10 000 of the radius
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
    : Plot(parent), m_arcs{new QLineSeries, new QLineSeries}, m_inset(new CentresInset(chart())) {
  for (QLineSeries* series : m_arcs) addSeries(series);
  m_inset->setZValue(90);
  setTitles(QStringLiteral("x (mm)"), QStringLiteral("y (mm)"));
}

void ArcPlot::setEvaluation(const Evaluation& evaluation) {
  m_picture = evaluation.arcs ? evaluation.arcs : std::make_shared<const ArcPicture>(arcPicture(evaluation));
  m_extent = m_picture->extent();
  setMessage(m_picture->isEmpty() ? QStringLiteral("No usable readings yet.") : QString());
  m_inset->setIntersection(m_picture->intersection);
  showArcs();
  showMarks();
  showLegend();
  rearrange();
}

void ArcPlot::showArcs() {
  std::array<QList<QPointF>, 2> points;
  for (const DrawnArc& arc : m_picture->arcs) points[arcIndex(arc.axisDeg)] = polyline(arc);
  for (std::size_t i = 0; i < points.size(); ++i) m_arcs[i]->replace(points[i]);
}

void ArcPlot::showMarks() {
  std::vector<Mark> marks;
  std::vector<Stick> sticks;
  marks.reserve(m_picture->sightings.size() + m_picture->excluded.size());
  for (const DrawnSighting& sighting : m_picture->sightings) {
    const QPointF at(sighting.sighted.x, sighting.sighted.y);
    marks.push_back({at, kindOf(sighting), sighting.ref});
    if (!sighting.adjusted) continue;
    const PlanePoint<double> end = m_picture->residualEnd(sighting);
    sticks.push_back(
        {QLineF(sighting.adjusted->x, sighting.adjusted->y, end.x, end.y), arcIndex(sighting.axisDeg)});
  }
  for (const DrawnSighting& sighting : m_picture->excluded) {
    marks.push_back({{sighting.sighted.x, sighting.sighted.y}, Excluded, sighting.ref});
  }
  markerLayer().setMarks(std::move(marks), std::move(sticks));
}

void ArcPlot::showLegend() {
  std::vector<LegendEntry> entries;
  for (const int axisDeg : {0, 180}) {
    for (const int time : {1, 2}) {
      const bool any = std::any_of(m_picture->sightings.begin(), m_picture->sightings.end(),
                                   [&](const DrawnSighting& sighting) {
                                     return sighting.axisDeg == axisDeg && (sighting.time > 1) == (time > 1);
                                   });
      if (!any) continue;
      entries.push_back({style().marker(axisDeg, MarkerShape::Circle, time),
                         QStringLiteral("arc at ") + positionText(axisDeg, time)});
    }
  }
  if (!m_picture->excluded.empty()) entries.push_back({style().excludedMarker(), QStringLiteral("excluded")});
  if (!m_picture->arcs.empty()) {
    entries.push_back({QPen(style().text, 1.4 * style().unit()),
                       QStringLiteral("residuals ") + exaggerationText(m_picture->exaggeration)});
  }
  legendItem().setEntries(std::move(entries));
}

void ArcPlot::applyStyle() {
  const double unit = style().unit();
  m_arcs[Upper]->setPen(QPen(style().upper, 1.3 * unit));
  m_arcs[Lower]->setPen(QPen(style().lower, 1.3 * unit, Qt::DashLine));
  markerLayer().setMarkers({style().marker(0, MarkerShape::Circle), style().marker(180, MarkerShape::Circle),
                            style().marker(0, MarkerShape::Circle, 2),
                            style().marker(180, MarkerShape::Circle, 2), style().excludedMarker()});
  markerLayer().setPens({QPen(style().upper, 1.4 * unit), QPen(style().lower, 1.4 * unit)});
  m_inset->setStyle(style());
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
  if (!m_picture->intersection) return;
  // The largest square about the centres that leaves the points, their residuals and the scales free.
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
  m_inset->setSquare(square);
}

const DrawnSighting* ArcPlot::sightingOf(const Mark& mark) const {
  for (const auto* list : {&m_picture->sightings, &m_picture->excluded}) {
    for (const DrawnSighting& sighting : *list) {
      if (sighting.ref == mark.ref) return &sighting;
    }
  }
  return nullptr;
}

QString ArcPlot::describe(const Mark& mark) const {
  const DrawnSighting* sighting = sightingOf(mark);
  if (!sighting) return {};
  QString text = QStringLiteral("Axis at %1, point %2, round %3, face %4\nx = %5, y = %6")
                     .arg(positionText(sighting->axisDeg, sighting->time))
                     .arg(sighting->point)
                     .arg(sighting->round)
                     .arg(sighting->face)
                     .arg(lengthText(sighting->sighted.x, 3), lengthText(sighting->sighted.y, 3));
  if (sighting->adjusted) {
    const PlanePoint<double>& foot = *sighting->adjusted;
    const double off = std::hypot(sighting->sighted.x - foot.x, sighting->sighted.y - foot.y);
    text += QStringLiteral("\n%1 from the adjusted point").arg(lengthText(off, 3));
  } else if (mark.kind == Excluded) {
    text += QStringLiteral("\nexcluded from the fit");
  }
  return text;
}

QString ArcPlot::summary() const {
  if (m_picture->isEmpty()) return message();
  return QStringLiteral("%1 sighted points, %2 fitted arcs, residuals drawn %3")
      .arg(m_picture->sightings.size())
      .arg(m_picture->arcs.size())
      .arg(exaggerationText(m_picture->exaggeration));
}

}  // namespace alidade::ui
