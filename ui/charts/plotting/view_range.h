#pragma once

#include <QRectF>
#include <optional>

namespace alidade::ui {

/// Which part of a whole plot is looked at, in axis units; `top` of a rectangle is its least y. Never more
/// than the whole: what is zoomed out as far as that follows the whole from then on.
class ViewRange {
 public:
  bool isWhole() const { return !m_part; }
  void reset() { m_part.reset(); }

  /// What is in sight of `whole`, which has the proportions of the frame where scales are equal: then the
  /// part has them, too.
  QRectF within(const QRectF& whole, bool hasEqualScales) const;

  // All of these know what is in sight: `shown` of `whole`.

  /// `factors` > 1 enlarge; `about` stays where it is.
  void zoom(const QSizeF& factors, const QPointF& about, const QRectF& shown, const QRectF& whole);
  void move(const QPointF& by, const QRectF& shown, const QRectF& whole);
  /// Moves no further than it must for `point` to be well in sight.
  void include(const QPointF& point, const QRectF& shown, const QRectF& whole);
  void show(const QRectF& part, const QRectF& whole);

 private:
  std::optional<QRectF> m_part;
};

}  // namespace alidade::ui
