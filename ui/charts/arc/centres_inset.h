#pragma once

#include <QFontMetricsF>
#include <QGraphicsItem>
#include <optional>

#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/text/headline.h"

namespace alidade::ui {

/// The headline in large type, and below it the two arc centres of the fit under a magnifier: O1 and O2 with
/// the ellipses that hold them at the coverage, the axis midway between them, the band where they may lie at
/// the tolerance, and the intersection Δd as the way from the axis to O1 with its expanded uncertainty. A
/// cross stands where closure would want O2, a broken line leads to it. One scale in x and y, shown by a bar
/// in mm.
class CentresInset : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void setStyle(const PlotStyle& style);
  void setHeadline(const Headline& headline);
  void setIntersection(const std::optional<DrawnIntersection>& intersection);
  /// The square it may use, in the parent's units; what does not fit into a small one is left out.
  void setSquare(const QRectF& square);

  /// Scene units to a millimetre; 0 where nothing is drawn.
  double scale() const { return m_scale; }
  /// From mm in o0 to the parent's units.
  QPointF place(const PlanePoint<double>& point) const;

  /// Where the names of the centres stand, while something is drawn, and that of the axis; empty where these
  /// leave it no room.
  QRectF upperNameRect() const;
  QRectF lowerNameRect() const;
  QRectF axisNameRect() const;

  /// A line above the picture.
  struct TitleLine {
    QString text;
    QFont font;
    QColor colour;
    double height = QFontMetricsF(font).height();  ///< that it takes up
  };
  /// Those that fit, from the top: the headline in large type, then in small type what the picture is of.
  /// None in a small picture.
  const QList<TitleLine>& titleLines() const { return m_titles; }

  QRectF boundingRect() const override { return m_square; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void updateScale();
  void layOutTitles();
  QList<TitleLine> headlineLines() const;
  TitleLine largeLine(const QString& text) const;
  double titlesHeight() const;
  double titleRoom() const;
  /// What the picture may reach into: text stands above and below it.
  QRectF frame() const;
  QRectF nameRect(const PlanePoint<double>& centre, const DrawnEllipse& ellipse, const QString& name) const;
  void paintBare(QPainter* painter) const;  // too small to enlarge anything: a plus where both centres are
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
  QRectF m_picture;          // where the centres may lie; the rest is text
  bool m_isCompact = false;  // where there is little room there is no title
  double m_scale = 0;
};

}  // namespace alidade::ui
