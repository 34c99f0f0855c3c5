#include "ui/charts/plotting/plot_accessible.h"

#include "ui/charts/plotting/plot_widget.h"

namespace alidade::ui {
namespace {

QAccessibleInterface* accessiblePlot(const QString&, QObject* object) {
  auto* plot = qobject_cast<PlotWidget*>(object);
  return plot ? new PlotAccessible(*plot) : nullptr;
}

}  // namespace

PlotAccessible::PlotAccessible(PlotWidget& plot)
    : QAccessibleWidget(&plot, QAccessible::Chart), m_plot(plot) {}

void PlotAccessible::install() {
  QAccessible::installFactory(accessiblePlot);  // does nothing where it is installed
}

QString PlotAccessible::text(QAccessible::Text which) const {
  return which == QAccessible::Value ? m_plot.currentPoint() : QAccessibleWidget::text(which);
}

}  // namespace alidade::ui
