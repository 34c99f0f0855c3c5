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

namespace alidade::ui {

class Caption;
class Plot;
struct Evaluation;
struct Mark;

/// A plot on the screen: follows the widget's size, palette and font, tells the point under the mouse, and
/// hands on a click on one. It is enlarged by the wheel, by a band drawn around a part, and by + and −; moved
/// with the middle button, Shift and the left one, or Shift and arrows; whole again by a double click or
/// Home; digits are left to the readings. Arrows lead from point to point, which is told to screen readers;
/// Enter activates it. A menu offers all this, pictures and numbers; below stands what a good one
/// looks like.
class PlotWidget : public QWidget, public ChartSource {
  Q_OBJECT

 public:
  ~PlotWidget() override;

  void setEvaluation(const Evaluation& evaluation);
  /// Enlarges the points of one row of readings: indices into the session's positions and their readings.
  void setHighlighted(std::size_t position, std::size_t row);
  void clearHighlight();
  /// Everything in sight.
  void showWhole();
  /// The point that the keyboard has led to, in words; empty: none.
  QString currentPoint() const;
  /// The points as they are counted for screen readers: how many, which the keyboard is on, their words and
  /// their places on the screen.
  std::size_t pointCount() const;
  std::optional<std::size_t> currentIndex() const;
  std::optional<std::size_t> pointAt(const QPoint& onScreen) const;
  QString pointText(std::size_t point) const;
  QRect pointRect(std::size_t point) const;
  bool isPointInSight(std::size_t point) const;
  /// What the menu offers, made anew.
  std::unique_ptr<QMenu> makeMenu();
  ChartFiles& files() { return *m_files; }

  PaintedPicture picture() override;
  std::string numbers() const override;

  QSize minimumSizeHint() const override { return {340, 280}; }
  QSize sizeHint() const override { return {640, 480}; }

 signals:
  void sightingActivated(std::size_t position, std::size_t row);
  /// The keyboard has led to a point of this row, and stays here.
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

  /// Adds what can be chosen to be drawn.
  virtual void addChoices(QMenu& menu);
  /// What is drawn has changed: caption and descriptions follow.
  void tell();

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
  void tellFocus();
  void showMenu(const QPoint& globalPlace);

  std::unique_ptr<Plot> m_plot;
  QGraphicsView* m_view;  // a child; goes before the plot does
  Caption* m_caption;
  QToolButton* m_menuButton;
  ChartFiles* m_files;
  QRubberBand* m_band;
  /// Stays until the next one is wanted: what was chosen in it may ask for a file meanwhile.
  std::unique_ptr<QMenu> m_menu;
  Drag m_drag = Drag::None;
  QPoint m_pressed, m_dragged;
};

}  // namespace alidade::ui
