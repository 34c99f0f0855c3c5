#pragma once

#include <QGraphicsItem>
#include <QPen>
#include <variant>
#include <vector>

#include "ui/charts/plotting/plot_style.h"

namespace alidade::ui {

/// A line of text with the sign it explains: a marker, a line or a band.
struct LegendEntry {
  std::variant<std::monostate, Marker, QPen, QColor> sign;
  QString text;
};

/// Flows its entries over as many lines as the width requires, so that none is cut off or squeezed.
class Legend : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void setStyle(const PlotStyle& style);
  void setEntries(std::vector<LegendEntry> entries);
  /// Lays the entries out from the item's origin, the first line shorter by `corner`; returns their height
  /// in scene units.
  double layOut(double width, double corner = 0);

  const std::vector<LegendEntry>& entries() const { return m_entries; }

  QRectF boundingRect() const override { return m_bounds; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintSign(QPainter* painter, const LegendEntry& entry, const QRectF& box) const;

  PlotStyle m_style;
  std::vector<LegendEntry> m_entries;
  std::vector<QPointF> m_places;
  QRectF m_bounds;
};

}  // namespace alidade::ui
