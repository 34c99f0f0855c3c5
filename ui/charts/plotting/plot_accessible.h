#pragma once

#include <QAccessibleWidget>

namespace alidade::ui {

class PlotWidget;

/// What a screen reader learns of a plot: name and summary as of any widget, and as its value the point that
/// the keyboard has led to.
class PlotAccessible : public QAccessibleWidget {
 public:
  explicit PlotAccessible(PlotWidget& plot);

  /// For all plots made from now on.
  static void install();

  QString text(QAccessible::Text which) const override;

 private:
  PlotWidget& m_plot;
};

}  // namespace alidade::ui
