#include "ui/charts/plotting/marker_layer.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade::ui {
namespace {

// From this number on, a marker is drawn once and copied, ten times faster than drawing each path.
constexpr std::size_t manyMarks = 400;

bool isPixelDevice(const QPainter* painter) {
  const QPaintEngine* engine = painter->paintEngine();
  return engine && engine->type() == QPaintEngine::Raster &&
         painter->device()->devType() != QInternal::Picture;
}

QPixmap markerPixmap(const Marker& marker, double pixelRatio) {
  const int side = static_cast<int>(std::ceil(marker.size * (marker.ringed   ? 2.6
                                                             : marker.struck ? 2.1
                                                                             : 1.5))) +
                   2;
  QPixmap pixmap(QSize(side, side) * pixelRatio);
  pixmap.setDevicePixelRatio(pixelRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  drawMarker(&painter, marker, {side / 2.0, side / 2.0});
  return pixmap;
}

}  // namespace

void MarkerLayer::setMarkers(std::vector<Marker> markers) {
  m_markers = std::move(markers);
  update();
}

void MarkerLayer::setPens(std::vector<QPen> pens) {
  m_pens = std::move(pens);
  update();
}

void MarkerLayer::setHighlightPen(const QPen& pen) {
  m_highlightPen = pen;
  update();
}

void MarkerLayer::setMarks(std::vector<Mark> marks, std::vector<Stick> sticks) {
  m_marks = std::move(marks);
  m_sticks = std::move(sticks);
  m_current.reset();
  m_isPlaced = false;
  update();
}

void MarkerLayer::setFrame(const QRectF& plotArea, const QTransform& sceneFromAxes) {
  prepareGeometryChange();
  m_plotArea = plotArea;
  m_sceneFromAxes = sceneFromAxes;
  m_isPlaced = false;
}

void MarkerLayer::setCurrent(std::optional<std::size_t> mark) {
  if (mark == m_current) return;
  m_current = mark;
  update();
}

void MarkerLayer::setHighlighted(std::optional<SightingRef> ref) {
  if (ref == m_highlighted) return;
  m_highlighted = ref;
  update();
}

const Mark* MarkerLayer::markNear(const QPointF& scene, double reach) const {
  const Mark* nearest = nullptr;
  double best = reach;
  for (const Mark& mark : m_marks) {
    const QPointF away = scenePosition(mark) - scene;
    const double distance = std::hypot(away.x(), away.y());
    if (distance <= best) {
      best = distance;
      nearest = &mark;
    }
  }
  return nearest;
}

/// Computes the places once for each new set of marks or frame, not at each painting.
void MarkerLayer::place() {
  if (std::exchange(m_isPlaced, true)) return;
  double size = 7;
  for (const Marker& marker : m_markers) size = std::min(size, marker.size);
  const Raster raster{m_plotArea, std::max(0.5 * size, 1.0)};
  m_placed = thinned(m_marks, m_sceneFromAxes, raster);
  m_placedSticks = thinned(m_sticks, m_sceneFromAxes, raster);
}

void MarkerLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  place();
  painter->save();
  painter->setClipRect(m_plotArea, Qt::IntersectClip);
  painter->setRenderHint(QPainter::Antialiasing);
  paintSticks(painter);
  if (m_placed.size() >= manyMarks && isPixelDevice(painter)) {
    paintManyMarks(painter);
  } else {
    paintMarks(painter);
  }
  paintHighlight(painter);
  paintCurrent(painter);
  painter->restore();
}

void MarkerLayer::paintSticks(QPainter* painter) const {
  for (std::size_t kind = 0; kind < m_pens.size(); ++kind) {
    QList<QLineF> lines;
    for (const Stick& stick : m_placedSticks)
      if (stick.kind == kind) lines.append(stick.line);
    if (lines.isEmpty()) continue;
    painter->setPen(m_pens[kind]);
    painter->drawLines(lines);
  }
}

void MarkerLayer::paintMarks(QPainter* painter) const {
  for (const PlacedMark& mark : m_placed) drawMarker(painter, m_markers[mark.kind], mark.at);
}

void MarkerLayer::paintManyMarks(QPainter* painter) const {
  std::vector<QPixmap> pixmaps;
  for (const Marker& marker : m_markers) {
    pixmaps.push_back(markerPixmap(marker, painter->device()->devicePixelRatioF()));
  }
  for (const PlacedMark& mark : m_placed) {
    const QPixmap& pixmap = pixmaps[mark.kind];
    const QSizeF size = pixmap.deviceIndependentSize();
    painter->drawPixmap(QPointF(mark.at.x() - size.width() / 2, mark.at.y() - size.height() / 2).toPoint(),
                        pixmap);
  }
}

void MarkerLayer::paintHighlight(QPainter* painter) const {
  if (!m_highlighted) return;
  for (const Mark& mark : m_marks) {
    if (mark.ref != *m_highlighted || !m_plotArea.contains(scenePosition(mark))) continue;
    Marker marker = m_markers[mark.kind];
    marker.size *= 1.6;
    const QPointF at = scenePosition(mark);
    drawMarker(painter, marker, at);
    painter->setPen(m_highlightPen);
    painter->setBrush(Qt::NoBrush);
    painter->drawEllipse(at, marker.size, marker.size);
  }
}

void MarkerLayer::paintCurrent(QPainter* painter) const {
  if (!m_current) return;
  const Mark& mark = m_marks[*m_current];
  const double reach = 1.9 * m_markers[mark.kind].size;
  painter->setPen(m_highlightPen);
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(QRectF(-reach, -reach, 2 * reach, 2 * reach).translated(scenePosition(mark)));
}

}  // namespace alidade::ui
