#include "ui/series/history_chart.h"

#include "core/evaluation/evaluation.h"

namespace alidade::ui {

HistoryChart::HistoryChart(QWidget* parent) : HistoryChart(new HistoryPlot, parent) {}

HistoryChart::HistoryChart(HistoryPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(tr("Control chart"));
  updateDescriptions();
}

void HistoryChart::setHistory(const History& history, const QString& quantity, const std::string& unit) {
  m_plot->setHistory(history, quantity, unit);
  updateDescriptions();
}

}  // namespace alidade::ui
