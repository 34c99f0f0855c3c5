#include "ui/instrument/check_chart.h"

namespace alidade::ui {

CheckChart::CheckChart(QWidget* parent) : CheckChart(new CheckPlot, parent) {}

CheckChart::CheckChart(CheckPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(tr("Chart of the check"));
  setMinimumSize(minimumSizeHint());
  updateDescriptions();
}

void CheckChart::setCheck(const SharedInstrument& check) {
  m_plot->setCheck(check);
  updateDescriptions();
}

void CheckChart::setView(CheckPlot::View view) {
  m_plot->setView(view);
  updateDescriptions();
}

}  // namespace alidade::ui
