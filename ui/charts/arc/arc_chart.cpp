#include "ui/charts/arc/arc_chart.h"

#include <QMenu>

#include "core/evaluation/evaluation.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/plotting/row_choice.h"

namespace alidade::ui {

ArcChart::ArcChart(QWidget* parent) : ArcChart(new ArcPlot, parent) {}

ArcChart::ArcChart(ArcPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(tr("Arcs and sighted points"));
  setEvaluation({});
}

void ArcChart::choose(const RowChoice& choice) {
  m_plot->setChoice(choice);
  updateDescriptions();
}

void ArcChart::addChoices(QMenu& menu) {
  menu.addSeparator();
  const RowKinds& kinds = m_plot->picture().kinds;
  addRowChoices(menu, kinds, m_plot->choice().among(kinds), [this](const RowChoice& rows) { choose(rows); });
}

}  // namespace alidade::ui
