#include "ui/charts/residuals/residual_chart.h"

#include "ui/charts/residuals/residual_plot.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

ResidualChart::ResidualChart(QWidget* parent) : ResidualChart(new ResidualPlot, parent) {}

ResidualChart::ResidualChart(ResidualPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(QStringLiteral("Residuals along the arc"));
  setEvaluation({});
}

}  // namespace alidade::ui
