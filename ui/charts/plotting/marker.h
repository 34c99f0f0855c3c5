#pragma once

#include <QColor>
#include <QPainterPath>

class QPainter;

namespace alidade::ui {

enum class MarkerShape { Circle, Diamond, Square, Cross, Plus };

/// The drawing of a kind of point. Fill and shape keep markers distinguishable in grey.
struct Marker {
  MarkerShape shape = MarkerShape::Circle;
  QColor colour;  ///< colour of the outline, and of the inside if `filled`
  QColor inside;  ///< colour inside a hollow marker: the plot's background
  bool filled = true;
  double size = 7;      ///< diameter in scene units
  bool ringed = false;  ///< with a ring of the same shape around it
  bool struck = false;  ///< with a slanting stroke through it

  bool operator==(const Marker&) const = default;
};

/// The marker's outline around the origin.
QPainterPath markerPath(MarkerShape shape, double size);

void drawMarker(QPainter* painter, const Marker& marker, const QPointF& at);

}  // namespace alidade::ui
