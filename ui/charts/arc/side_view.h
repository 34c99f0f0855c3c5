#pragma once

#include <QGraphicsItem>
#include <QStringList>
#include <optional>

#include "core/statement/headline.h"
#include "ui/charts/plotting/plot_style.h"

namespace alidade::ui {

/// The arc's centre seen along the axis of rotation, Δd up and Δz towards the theodolite: O1 (axis at 0°)
/// with U in both directions, and O2 (axis at 180°) opposite. A cross of lines is the axis. The tolerance is
/// a band of Δd or a circle of the distance. Both directions have the same scale, shown by a bar in mm. Δz is
/// written above if there is room.
class SideView : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void setStyle(const PlotStyle& style);
  void setOffset(const std::optional<CentreOffset>& offset);
  /// The available rectangle, in the parent's units. The title is left out if there is no room for it.
  void setSquare(const QRectF& square);

  bool isMeasured() const { return m_offset.has_value(); }
  /// Scene units per millimetre; 0 if nothing is drawn.
  double scale() const { return m_scale; }
  /// The place of the centre at 0° in the parent's units.
  QPointF centre() const;
  /// The place of the name of the centre with the axis at `axisDeg`, 0 or 180.
  QRectF nameRect(int axisDeg) const;
  /// The line at the top; empty if it has no room.
  QStringList title() const { return m_title; }

  QRectF boundingRect() const override { return m_square; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void updateScale();
  double line() const;  ///< height of a line of text
  QStringList titleThatFits() const;
  void paintTolerance(QPainter& painter) const;
  void paintAxis(QPainter& painter) const;
  void paintCentres(QPainter& painter) const;
  void paintTexts(QPainter& painter) const;

  PlotStyle m_style;
  std::optional<CentreOffset> m_offset;
  QStringList m_title;  ///< parts of the title, the first at the left, the last at the right
  QRectF m_square, m_picture;
  double m_scale = 0;
};

}  // namespace alidade::ui
