#include "ui/charts/plotting/view_range.h"

#include <algorithm>

namespace alidade::ui {
namespace {

constexpr double largestZoom = 1e5;
constexpr double margin = 0.05;  // share of the visible range, around a point that must be visible

QRectF inside(QRectF part, const QRectF& whole) {
  part.setSize(QSizeF(std::clamp(part.width(), whole.width() / largestZoom, whole.width()),
                      std::clamp(part.height(), whole.height() / largestZoom, whole.height())));
  part.moveLeft(std::clamp(part.left(), whole.left(), whole.right() - part.width()));
  part.moveTop(std::clamp(part.top(), whole.top(), whole.bottom() - part.height()));
  return part;
}

/// The distance to move [low, high] so that it contains `value`.
double way(double value, double low, double high) {
  return value < low ? value - low : value > high ? value - high : 0;
}

}  // namespace

QRectF ViewRange::within(const QRectF& whole, bool hasEqualScales) const {
  if (!m_part) return whole;
  QRectF part = *m_part;
  if (hasEqualScales) {
    const double share = std::max(part.width() / whole.width(), part.height() / whole.height());
    part.setSize(whole.size() * share);
    part.moveCenter(m_part->center());
  }
  return inside(part, whole);
}

void ViewRange::zoom(const QSizeF& factors, const QPointF& about, const QRectF& shown, const QRectF& whole) {
  const double width = std::max(shown.width() / factors.width(), whole.width() / largestZoom);
  const double height = std::max(shown.height() / factors.height(), whole.height() / largestZoom);
  const double left = about.x() - (about.x() - shown.left()) * width / shown.width();
  const double top = about.y() - (about.y() - shown.top()) * height / shown.height();
  show(QRectF(left, top, width, height), whole);
}

void ViewRange::move(const QPointF& by, const QRectF& shown, const QRectF& whole) {
  if (m_part) m_part = inside(shown.translated(by), whole);
}

void ViewRange::include(const QPointF& point, const QRectF& shown, const QRectF& whole) {
  const QRectF well = shown.adjusted(margin * shown.width(), margin * shown.height(), -margin * shown.width(),
                                     -margin * shown.height());
  move({way(point.x(), well.left(), well.right()), way(point.y(), well.top(), well.bottom())}, shown, whole);
}

void ViewRange::show(const QRectF& part, const QRectF& whole) {
  constexpr double nearly = 1 - 1e-9;
  if (part.width() >= nearly * whole.width() && part.height() >= nearly * whole.height())
    m_part.reset();
  else
    m_part = inside(part, whole);
}

}  // namespace alidade::ui
