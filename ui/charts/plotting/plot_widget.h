#pragma once

#include <QWidget>
#include <cstddef>
#include <memory>

class QGraphicsView;

namespace alidade::ui {

class Plot;
struct Evaluation;

/// A plot on the screen: follows the widget's size, palette and font, tells the point under the mouse, and
/// hands on a click on one.
class PlotWidget : public QWidget {
  Q_OBJECT

 public:
  ~PlotWidget() override;

  void setEvaluation(const Evaluation& evaluation);
  /// Enlarges the points of one row of readings: indices into the session's positions and their readings.
  void setHighlighted(std::size_t position, std::size_t row);
  void clearHighlight();

  QSize minimumSizeHint() const override { return {340, 280}; }
  QSize sizeHint() const override { return {640, 480}; }

 signals:
  void sightingActivated(std::size_t position, std::size_t row);

 protected:
  PlotWidget(std::unique_ptr<Plot> plot, QWidget* parent);

  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void restyle();
  void hover(const QPoint& place, const QPoint& globalPlace);
  void activate(const QPoint& place);

  std::unique_ptr<Plot> m_plot;
  QGraphicsView* m_view;  // a child; goes before the plot does
  QPoint m_pressed;
};

}  // namespace alidade::ui
