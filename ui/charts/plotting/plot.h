#pragma once

#include <QGraphicsScene>
#include <QObject>
#include <QtCharts/QChart>
#include <QtCharts/QValueAxis>
#include <optional>

#include "ui/charts/plotting/legend.h"
#include "ui/charts/plotting/marker_layer.h"
#include "ui/charts/plotting/plot_style.h"

namespace alidade::ui {

struct Evaluation;

/// A chart with its axes, points and legend in a scene of its own. The widget shows the scene, the report
/// renders it: one drawing code for both. Laid out by `arrange`, at once and without waiting for events.
class Plot : public QObject {
  Q_OBJECT

 public:
  explicit Plot(QObject* parent = nullptr);
  ~Plot() override;

  virtual void setEvaluation(const Evaluation& evaluation) = 0;
  void setStyle(const PlotStyle& style);
  void setHighlighted(std::optional<SightingRef> ref);
  void arrange(const QSizeF& size);

  QGraphicsScene* scene() { return &m_scene; }
  const PlotStyle& style() const { return m_style; }
  QRectF plotArea() const { return m_plotArea; }
  /// From axis units to the scene, y up in the first and down in the second.
  QTransform sceneFromAxes() const { return m_sceneFromAxes; }
  const MarkerLayer& markers() const { return *m_markers; }
  const Legend& legend() const { return *m_legend; }
  /// The sentence in the middle of an empty plot; empty where there is something to see.
  QString message() const { return m_message; }

  /// The point at a place in the scene; null where there is none near.
  const Mark* markAt(const QPointF& scene) const;
  /// What a pointing hand wants to know of one of `markers().marks()`; plain text.
  virtual QString describe(const Mark& mark) const = 0;
  /// The picture in a few words, for screen readers.
  virtual QString summary() const = 0;

 protected:
  /// Colours, pens and markers of what the plot itself adds.
  virtual void applyStyle() = 0;
  /// The ranges for a plot area of this size, in scene units: what must be visible, in axis units.
  virtual QRectF axisRange(const QSizeF& plotArea) const = 0;
  /// A millimetre is as long in x as in y, and so are the ticks.
  virtual bool hasEqualScales() const { return false; }
  /// Called when the frame is known: place what follows it.
  virtual void placeExtras() {}

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
  void applyTicks(QValueAxis* axis, double step) const;
  void fitRangeToPlotArea();

  PlotStyle m_style;
  QGraphicsScene m_scene;
  QChart* m_chart;  // owned by the scene
  QValueAxis* m_x;  // owned by the chart
  QValueAxis* m_y;
  MarkerLayer* m_markers;
  Legend* m_legend;
  QGraphicsSimpleTextItem* m_messageItem;
  QString m_message;
  QSizeF m_size;
  QRectF m_plotArea;
  QTransform m_sceneFromAxes;
};

}  // namespace alidade::ui
