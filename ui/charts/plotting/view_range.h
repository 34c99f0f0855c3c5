#pragma once

#include <QRectF>
#include <optional>

namespace alidade::ui {

/// The visible part of a plot, in axis units; `top` of a rectangle is its least y. Never more than the whole;
/// zooming out to the whole makes the part follow later changes of the whole.
class ViewRange {
 public:
  bool isWhole() const { return !m_part; }
  void reset() { m_part.reset(); }

  /// The visible part of `whole`. With equal scales `whole` has the frame's proportions, and so has the part.
  QRectF within(const QRectF& whole, bool hasEqualScales) const;

  // `shown` is the visible part of `whole`.

  /// `factors` > 1 enlarge; `about` keeps its place.
  void zoom(const QSizeF& factors, const QPointF& about, const QRectF& shown, const QRectF& whole);
  void move(const QPointF& by, const QRectF& shown, const QRectF& whole);
  /// Moves as little as possible to make `point` well visible.
  void include(const QPointF& point, const QRectF& shown, const QRectF& whole);
  void show(const QRectF& part, const QRectF& whole);

 private:
  std::optional<QRectF> m_part;
};

}  // namespace alidade::ui
