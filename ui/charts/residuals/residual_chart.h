#pragma once

#include "ui/charts/plotting/plot_widget.h"

namespace alidade::ui {

class ResidualPlot;

/// The residuals of every reading along the arc, on the screen.
class ResidualChart : public PlotWidget {
  Q_OBJECT

 public:
  explicit ResidualChart(QWidget* parent = nullptr);

  ResidualPlot* plot() const { return m_plot; }

 private:
  explicit ResidualChart(ResidualPlot* plot, QWidget* parent);

  ResidualPlot* m_plot;  // owned by the base
};

}  // namespace alidade::ui
