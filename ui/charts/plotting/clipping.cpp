#include "ui/charts/plotting/clipping.h"

#include <algorithm>
#include <cmath>

namespace alidade::ui {

/// Liang and Barsky, "A new concept and method for line clipping" (1984).
std::optional<QLineF> clipped(const QLineF& line, const QRectF& frame) {
  const double dx = line.dx(), dy = line.dy();
  if (!std::isfinite(dx) || !std::isfinite(dy)) return std::nullopt;
  double from = 0, to = 1;
  const double along[] = {-dx, dx, -dy, dy};
  const double room[] = {line.x1() - frame.left(), frame.right() - line.x1(), line.y1() - frame.top(),
                         frame.bottom() - line.y1()};
  for (int side = 0; side < 4; ++side) {
    if (along[side] == 0) {
      if (room[side] < 0) return std::nullopt;
      continue;
    }
    const double at = room[side] / along[side];
    if (along[side] < 0)
      from = std::max(from, at);
    else
      to = std::min(to, at);
  }
  if (from > to) return std::nullopt;
  return QLineF(from > 0 ? line.pointAt(from) : line.p1(), to < 1 ? line.pointAt(to) : line.p2());
}

QList<QList<QPointF>> clipped(const QList<QPointF>& polyline, const QRectF& frame) {
  QList<QList<QPointF>> pieces;
  bool goesOn = false;
  for (qsizetype i = 0; i + 1 < polyline.size(); ++i) {
    const auto part = clipped(QLineF(polyline[i], polyline[i + 1]), frame);
    if (!part) {
      goesOn = false;
      continue;
    }
    if (!goesOn) pieces.append({part->p1()});
    pieces.last().append(part->p2());
    goesOn = part->p2() == polyline[i + 1];
  }
  return pieces;
}

}  // namespace alidade::ui
