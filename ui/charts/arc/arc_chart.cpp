#include "ui/charts/arc/arc_chart.h"

#include "ui/charts/arc/arc_plot.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

ArcChart::ArcChart(QWidget* parent) : ArcChart(new ArcPlot, parent) {}

ArcChart::ArcChart(ArcPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(QStringLiteral("Arcs and sighted points"));
  setEvaluation({});
}

}  // namespace alidade::ui
