#pragma once

#include <QFontMetricsF>
#include <QGraphicsItem>
#include <limits>
#include <optional>

#include "core/statement/headline.h"
#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/plotting/plot_style.h"

namespace alidade::ui {

/// The headline in large type, and below it the two arc centres, enlarged: O1 and O2 with their coverage
/// ellipses, the axis midway between them, the tolerance band, and Δd with its expanded uncertainty from the
/// axis to O1. A plus marks O2 at closure, and a dotted line leads from the plus to O2. x and y have the same
/// scale, shown by a bar in mm.
class CentresInset : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void setStyle(const PlotStyle& style);
  void setHeadline(const Headline& headline);
  void setIntersection(const std::optional<DrawnIntersection>& intersection);
  /// The available square, in the parent's units; contents that do not fit are left out.
  void setSquare(const QRectF& square);

  /// Scene units per millimetre; 0 if nothing is drawn.
  double scale() const { return m_scale; }
  /// Converts from mm in o0 to the parent's units.
  QPointF place(const PlanePoint<double>& point) const;

  /// The places of the names: O1 and O2, valid while drawn; the axis, empty if the name has no room.
  QRectF upperNameRect() const;
  QRectF lowerNameRect() const;
  QRectF axisNameRect() const;

  static constexpr int largest = std::numeric_limits<int>::max();
  /// A line above the picture.
  struct TitleLine {
    QString text;
    QFont font;
    QColor colour;
    double height = QFontMetricsF(font).height();
  };
  /// The lines that fit, from the top: the headline in large type, then the subject of the picture in small
  /// type. Empty for a small picture.
  const QList<TitleLine>& titleLines() const { return m_titles; }
  /// The whole first warning of the headline if the lines show only a part of it or a sign; otherwise empty.
  const QString& cutWarning() const { return m_cutWarning; }

  QRectF boundingRect() const override { return m_square; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void updateScale();
  void layOutTitles();
  QList<TitleLine> headlineLines(bool isMarked) const;
  TitleLine largeLine(const QString& text, int most = largest) const;
  double titlesHeight() const;
  double titleRoom() const;
  /// The area of the picture; text is above and below this area.
  QRectF frame() const;
  QRectF nameRect(const PlanePoint<double>& centre, const DrawnEllipse& ellipse, const QString& name) const;
  void paintBare(QPainter* painter) const;  // in a small square: one plus for both centres
  void paintTolerance(QPainter* painter) const;
  void paintAxis(QPainter* painter) const;
  void paintEllipses(QPainter* painter) const;
  void paintClosure(QPainter* painter) const;
  void paintCentres(QPainter* painter) const;
  void paintDistance(QPainter* painter) const;
  void paintScaleBar(QPainter* painter) const;
  void paintTitle(QPainter* painter) const;

  PlotStyle m_style;
  Headline m_headline;
  std::optional<DrawnIntersection> m_intersection;
  QRectF m_square;
  QList<TitleLine> m_titles;
  QString m_cutWarning;
  QRectF m_picture;          // area for the centres; the rest is text
  bool m_isCompact = false;  // too little room for a title
  double m_scale = 0;
};

}  // namespace alidade::ui
