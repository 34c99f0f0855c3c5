#include "ui/charts/gap/form_chart.h"

#include <QWheelEvent>

namespace alidade::ui {

FormChart::FormChart(QWidget* parent) : FormChart(new FormPlot, parent) {}

FormChart::FormChart(FormPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(tr("Form of the gap"));
  setMinimumSize(minimumSizeHint());
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void FormChart::setForm(const Gap& gap, std::size_t index) {
  m_plot->setForm(gap, index);
  updateDescriptions();
}

bool FormChart::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel &&
      !(static_cast<QWheelEvent*>(event)->modifiers() & Qt::ControlModifier)) {
    event->ignore();
    return true;
  }
  return PlotWidget::eventFilter(watched, event);
}

}  // namespace alidade::ui
