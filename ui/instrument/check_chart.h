#pragma once

#include "ui/charts/plotting/plot_widget.h"
#include "ui/instrument/check_plot.h"

namespace alidade::ui {

/// The points of an instrument check on the screen.
class CheckChart : public PlotWidget {
  Q_OBJECT

 public:
  explicit CheckChart(QWidget* parent = nullptr);

  CheckPlot* plot() const { return m_plot; }
  void setCheck(const SharedInstrument& check);
  void setView(CheckPlot::View view);

  QString fileName() const override { return QStringLiteral("instrument-check"); }
  QSize minimumSizeHint() const override { return {300, 220}; }

 private:
  explicit CheckChart(CheckPlot* plot, QWidget* parent);

  CheckPlot* m_plot;  // owned by the base
};

}  // namespace alidade::ui
