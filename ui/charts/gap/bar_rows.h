#pragma once

#include <QMenu>
#include <QWidget>
#include <memory>

#include "ui/charts/plotting/chart_files.h"

namespace alidade::ui {

/// A painted picture of bars in rows, as high as its rows and as wide as available, with tool tips. A menu,
/// also by keyboard, offers the picture and its numbers.
class BarRows : public QWidget, public ChartSource {
  Q_OBJECT

 public:
  /// `fileName`: without suffix.
  BarRows(const QString& accessibleName, const QString& fileName, QWidget* parent = nullptr);

  QString fileName() const override { return m_fileName; }
  PaintedPicture picture() override;

  QSize sizeHint() const override { return {420, pictureHeight()}; }
  QSize minimumSizeHint() const override { return {260, pictureHeight()}; }

 protected:
  bool event(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  int rowHeight() const { return fontMetrics().height() + 9; }
  /// Sets new rows; `accessible` is their text for screen readers.
  void changeTo(const QString& accessible);

  virtual int pictureHeight() const = 0;
  /// The tool tip at `point`; empty: none.
  virtual QString aboutAt(const QPoint& point) const = 0;

 private:
  QString m_fileName;
  ChartFiles* m_files;
  std::unique_ptr<QMenu> m_menu;  ///< the menu opened last
};

}  // namespace alidade::ui
