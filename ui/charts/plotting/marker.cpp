#include "ui/charts/plotting/marker.h"

#include <QPainter>
#include <QPen>

namespace alidade::ui {

QPainterPath markerPath(MarkerShape shape, double size) {
  const double r = size / 2;
  QPainterPath path;
  switch (shape) {
    case MarkerShape::Circle:
      path.addEllipse(QPointF(), r, r);
      break;
    case MarkerShape::Diamond: {
      const double d = r * 1.25;  // looks as large as the circle
      path.addPolygon(QPolygonF({{0, -d}, {d, 0}, {0, d}, {-d, 0}, {0, -d}}));
      break;
    }
    case MarkerShape::Square: {
      const double d = r * 0.9;
      path.addRect(QRectF(-d, -d, 2 * d, 2 * d));
      break;
    }
    case MarkerShape::Cross:
      path.moveTo(-r, -r);
      path.lineTo(r, r);
      path.moveTo(-r, r);
      path.lineTo(r, -r);
      break;
    case MarkerShape::Plus:
      path.moveTo(-r, 0);
      path.lineTo(r, 0);
      path.moveTo(0, -r);
      path.lineTo(0, r);
      break;
  }
  return path;
}

void drawMarker(QPainter* painter, const Marker& marker, const QPointF& at) {
  const bool open = marker.shape == MarkerShape::Cross || marker.shape == MarkerShape::Plus;
  painter->setPen(QPen(marker.colour, marker.size / 5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  if (open) {
    painter->setBrush(Qt::NoBrush);
  } else {
    painter->setBrush(marker.filled ? marker.colour : marker.inside);
  }
  painter->drawPath(markerPath(marker.shape, marker.size * 0.9).translated(at));
  if (marker.struck) {
    const QPointF end(0.85 * marker.size, -0.85 * marker.size);
    painter->drawLine(at - end, at + end);
  }
  if (!marker.ringed) return;
  painter->setPen(QPen(marker.colour, marker.size / 6));
  painter->setBrush(Qt::NoBrush);
  painter->drawPath(markerPath(marker.shape, marker.size * 1.9).translated(at));
}

}  // namespace alidade::ui
