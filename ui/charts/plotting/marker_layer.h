#pragma once

#include <QGraphicsItem>
#include <QPen>
#include <QTransform>
#include <optional>
#include <vector>

#include "ui/charts/plotting/mark.h"
#include "ui/charts/plotting/marker.h"
#include "ui/charts/plotting/thinning.h"

namespace alidade::ui {

/// All points of a plot in one item, instead of one graphics item per point as in Qt Charts. Painted as
/// vectors, or copied from a drawn marker if there are many on a pixel device. Of very many points, only
/// visible points are painted (thinning.h).
class MarkerLayer : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void setMarkers(std::vector<Marker> markers);
  void setPens(std::vector<QPen> pens);
  void setHighlightPen(const QPen& pen);
  void setMarks(std::vector<Mark> marks, std::vector<Stick> sticks = {});
  /// The plot area in scene units, and the transform from axis units to scene units.
  void setFrame(const QRectF& plotArea, const QTransform& sceneFromAxes);
  void setHighlighted(std::optional<SightingRef> ref);
  /// Draws a frame around one of `marks()`. New marks remove the frame.
  void setCurrent(std::optional<std::size_t> mark);

  const std::vector<Mark>& marks() const { return m_marks; }
  const std::vector<Stick>& sticks() const { return m_sticks; }
  std::optional<SightingRef> highlighted() const { return m_highlighted; }
  std::optional<std::size_t> current() const { return m_current; }
  QPointF scenePosition(const Mark& mark) const { return m_sceneFromAxes.map(mark.at) + mark.shift; }
  /// The number of marks and sticks in the last painting.
  std::size_t paintedCount() const { return m_placed.size() + m_placedSticks.size(); }
  /// The mark nearest to a place in the plot, within `reach` scene units; null if no mark is near.
  const Mark* markNear(const QPointF& scene, double reach) const;

  QRectF boundingRect() const override { return m_plotArea; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void place();
  void paintSticks(QPainter* painter) const;
  void paintMarks(QPainter* painter) const;
  void paintManyMarks(QPainter* painter) const;
  void paintHighlight(QPainter* painter) const;
  void paintCurrent(QPainter* painter) const;

  std::vector<Marker> m_markers;
  std::vector<QPen> m_pens;
  QPen m_highlightPen;
  std::vector<Mark> m_marks;
  std::vector<Stick> m_sticks;
  QRectF m_plotArea;
  QTransform m_sceneFromAxes;
  std::optional<SightingRef> m_highlighted;
  std::optional<std::size_t> m_current;
  bool m_isPlaced = false;            ///< true: the two members below are up to date
  std::vector<PlacedMark> m_placed;   ///< the marks to paint
  std::vector<Stick> m_placedSticks;  ///< in scene units
};

}  // namespace alidade::ui
