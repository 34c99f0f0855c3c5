#pragma once

#include <QMenu>
#include <QWidget>
#include <cstddef>
#include <memory>
#include <optional>

#include "ui/charts/plotting/chart_files.h"

class QGraphicsView;
class QMouseEvent;
class QRubberBand;
class QToolButton;

namespace alidade {
struct Evaluation;
}  // namespace alidade

namespace alidade::ui {

class Caption;
class Plot;
struct Mark;

/// A plot on the screen: follows the widget's size, palette and font, describes the point under the mouse,
/// and reports clicks on points.
/// Zoom: wheel, rubber band, + and −. Move: drag with the middle button, or Shift with the left button or the
/// arrow keys. Whole plot: double click or Home. Arrow keys alone move from point to point, which screen
/// readers announce; Enter activates the point. Digits are passed on to the table of readings.
/// A menu offers zoom, pictures and numbers; a caption says what a good plot looks like.
class PlotWidget : public QWidget, public ChartSource {
  Q_OBJECT

 public:
  ~PlotWidget() override;

  void setEvaluation(const Evaluation& evaluation);
  /// Enlarges the points of one row of readings: indices into the session's positions and their readings.
  void setHighlighted(std::size_t position, std::size_t row);
  void clearHighlight();
  void showWhole();
  /// The text of the point the keyboard selected; empty: none.
  QString currentPoint() const;
  /// The points for screen readers: their number, the current point, texts, and places on the screen.
  std::size_t pointCount() const;
  std::optional<std::size_t> currentIndex() const;
  std::optional<std::size_t> pointAt(const QPoint& onScreen) const;
  QString pointText(std::size_t point) const;
  QRect pointRect(std::size_t point) const;
  bool isPointInSight(std::size_t point) const;
  std::unique_ptr<QMenu> makeMenu();
  ChartFiles& files() { return *m_files; }

  PaintedPicture picture() override;
  std::string numbers() const override;

  QSize minimumSizeHint() const override { return {340, 280}; }
  QSize sizeHint() const override { return {640, 480}; }

 signals:
  void sightingActivated(std::size_t position, std::size_t row);
  /// The keyboard selected a point of this row; the keyboard focus stays in the chart.
  void sightingStepped(std::size_t position, std::size_t row);

 protected:
  PlotWidget(std::unique_ptr<Plot> plot, QWidget* parent);

  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  /// Adds choices of what is drawn.
  virtual void addChoices(QMenu& menu);
  /// Updates caption and descriptions; to be called after the drawn contents changed.
  void updateDescriptions();

 private:
  enum class Drag { None, Press, Band, Move };

  void restyle();
  void hover(const QPoint& place, const QPoint& globalPlace);
  void activate(const QPoint& place);
  void press(const QMouseEvent& mouse);
  void drag(const QMouseEvent& mouse);
  void release(const QMouseEvent& mouse);
  void endDrag();
  void zoomAtCurrent(double factor);
  bool movedBy(int key);
  bool steppedBy(int key);
  void announceFocus();
  void showMenu(const QPoint& globalPlace);

  std::unique_ptr<Plot> m_plot;
  QGraphicsView* m_view;  // a child; deleted before the plot
  Caption* m_caption;
  QToolButton* m_menuButton;
  ChartFiles* m_files;
  QRubberBand* m_band;
  /// The last menu, kept until the next one opens, since a command of it may still be asking for a file.
  std::unique_ptr<QMenu> m_menu;
  Drag m_drag = Drag::None;
  QPoint m_pressed, m_dragged;
};

}  // namespace alidade::ui
