#pragma once

#include <QWidget>

namespace alidade::ui {

/// A painted picture of bars below one another, as high as its rows and as wide as there is room, which tells
/// at the pointer what it shows there.
class BarRows : public QWidget {
  Q_OBJECT

 public:
  explicit BarRows(const QString& accessibleName, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {420, pictureHeight()}; }
  QSize minimumSizeHint() const override { return {260, pictureHeight()}; }

 protected:
  bool event(QEvent* event) override;
  int rowHeight() const { return fontMetrics().height() + 9; }
  /// The rows are others: `spoken` is what they say.
  void changeTo(const QString& spoken);

  virtual int pictureHeight() const = 0;
  /// What to tell at `point`; empty: nothing.
  virtual QString aboutAt(const QPoint& point) const = 0;
};

}  // namespace alidade::ui
