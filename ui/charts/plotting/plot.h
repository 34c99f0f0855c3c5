#pragma once

#include <QGraphicsScene>
#include <QObject>
#include <QtCharts/QChart>
#include <QtCharts/QValueAxis>
#include <cstdint>
#include <optional>
#include <string>

#include "ui/charts/plotting/legend.h"
#include "ui/charts/plotting/marker_layer.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/charts/plotting/view_range.h"

namespace alidade {
struct Evaluation;
}  // namespace alidade

namespace alidade::ui {

/// A chart with axes, points and legend in its own scene. The widget shows the scene, the report renders it:
/// one drawing code for both. `arrange` lays it out at once, without waiting for events.
class Plot : public QObject {
  Q_OBJECT

 public:
  /// `hasNamedX`: the ticks of x are `xTicks`, instead of round numbers.
  explicit Plot(QObject* parent = nullptr, bool hasNamedX = false);
  ~Plot() override;

  virtual void setEvaluation(const Evaluation& evaluation) = 0;
  void setStyle(const PlotStyle& style);
  void setHighlighted(std::optional<SightingRef> ref);
  void arrange(const QSizeF& size);

  QGraphicsScene* scene() { return &m_scene; }
  const PlotStyle& style() const { return m_style; }
  QRectF plotArea() const { return m_plotArea; }
  /// Converts from axis units, y up, to the scene, y down.
  QTransform sceneFromAxes() const { return m_sceneFromAxes; }
  const MarkerLayer& markers() const { return *m_markers; }
  const Legend& legend() const { return *m_legend; }
  /// The sentence in the middle of an empty plot; empty if the plot has contents.
  QString message() const { return m_message; }

  bool isZoomed() const { return !m_view.isWhole(); }
  /// Enlarges if `factor` > 1, about a place in the scene. A place next to an axis, outside the plot area,
  /// enlarges along that axis only.
  void zoom(double factor, const QPointF& about);
  /// Enlarges a part of the visible area, in scene units.
  void zoomTo(const QRectF& part);
  void move(const QPointF& by);
  void showWhole();

  /// Moves to the next point in a direction. Without a current point, starts at the highlighted row, or else
  /// at the end of the plot from which the step leads away. Null if there are no points.
  enum class Step { Left, Right, Down, Up };
  const Mark* step(Step step);
  const Mark* current() const;
  void clearCurrent() { m_markers->setCurrent({}); }

  /// Paints the visible contents at (0, 0) of the painter.
  void paint(QPainter* painter);

  /// The point at a place in the scene; null if no point is near.
  const Mark* markAt(const QPointF& scene) const;
  /// The tool tip of one of `markers().marks()`; plain text.
  virtual QString describe(const Mark& mark) const = 0;
  /// The tool tip at a place in the scene without a point; plain text, often empty.
  virtual QString tipAt(const QPointF& /*scene*/) const { return {}; }
  /// The picture in a few words, for screen readers.
  virtual QString summary() const = 0;
  /// A sentence on what a good plot looks like.
  virtual QString standard() const = 0;
  /// Everything drawn, regardless of zoom, as a table with units in the column names (`CsvText`).
  virtual std::string csv() const = 0;
  /// The room at the top right that the legend leaves free, in scene units.
  void setCorner(double width);

 protected:
  /// Sets colours, pens and markers of the derived plot's own items.
  virtual void applyStyle() = 0;
  /// The ranges of the axes, in axis units, that must be visible in a plot area of this size in scene units.
  virtual QRectF axisRange(const QSizeF& plotArea) const = 0;
  /// True if a millimetre has the same length in x and y, with equal ticks where both axes have room for
  /// enough labels.
  virtual bool hasEqualScales() const { return false; }
  struct Tick {
    double at = 0;  ///< in axis units
    QString label;
  };
  /// `xTicks`: ticks of a named x axis, ascending, at most `most`. `widestXLabel`: widest label of any tick.
  virtual std::vector<Tick> xTicks(double /*low*/, double /*high*/, std::size_t /*most*/) const { return {}; }
  virtual QString widestXLabel() const { return {}; }
  /// The least distance of ticks in a plot that is not zoomed: 1 if the axis counts, 0: any.
  virtual double leastXStep() const { return 0; }
  virtual double leastYStep() const { return 0; }
  /// Called before the layout, with the size of the plot in scene units.
  virtual void adaptTo(const QSizeF&) {}
  /// Called when the frame is known, to place items that depend on it.
  virtual void placeExtras() {}

  /// Shows these marks; the current point stays at the same reading.
  void showMarks(std::vector<Mark> marks, std::vector<Stick> sticks = {});
  void setMessage(const QString& message);
  void setTitles(const QString& x, const QString& y);
  void rearrange();
  void addSeries(QAbstractSeries* series);

  QChart* chart() { return m_chart; }
  MarkerLayer& markerLayer() { return *m_markers; }
  Legend& legendItem() { return *m_legend; }

 private:
  void styleAxis(QValueAxis* axis) const;
  void applyRange(const QRectF& range);
  void applyNames(const QRectF& range);
  std::vector<Tick> namesFor(const QRectF& range) const;
  void applyTicks(QValueAxis* axis, double step) const;
  void fitRangeToPlotArea();
  QRectF shownRange() const;
  const std::vector<std::uint32_t>& orderAlong(bool isVertical);

  PlotStyle m_style;
  QGraphicsScene m_scene;
  QChart* m_chart;  // owned by the scene
  QValueAxis* m_x;  // owned by the chart; a QCategoryAxis if it is named
  QValueAxis* m_y;
  MarkerLayer* m_markers;
  Legend* m_legend;
  QGraphicsSimpleTextItem* m_messageItem;
  QString m_message;
  QSizeF m_size;
  QRectF m_plotArea;
  QRectF m_whole;  ///< range that shows everything
  ViewRange m_view;
  double m_corner = 0;
  std::vector<std::uint32_t> m_alongX,
      m_alongY;  ///< indices of marks in the order of x and y; empty: not computed
  QTransform m_sceneFromAxes;
};

}  // namespace alidade::ui
