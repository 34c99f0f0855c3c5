#include "ui/panels/uncertainty/budget_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "core/statement/budget.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/panels/uncertainty/simulation_box.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

BudgetPanel::BudgetPanel(const SessionDocument& document, QWidget* parent)
    : ScrollPage(tr("Budget"), parent),
      m_measured(new StatementView),
      m_intersection(new StatementView),
      m_simulation(new SimulationBox(document)),
      m_centres(new StatementView),
      m_note(new QLabel(tr("No arc is fitted yet, so there is no budget."))) {
  m_note->setWordWrap(true);
  m_note->setForegroundRole(QPalette::PlaceholderText);
  QVBoxLayout* layout = column();
  layout->addWidget(m_measured);
  layout->addWidget(m_intersection);
  layout->addWidget(m_simulation);
  layout->addWidget(m_centres);
  layout->addSpacing(6);
  layout->addWidget(m_note);
  layout->addStretch();
  connect(m_simulation, &SimulationBox::checked, this, &BudgetPanel::checked);
}

void BudgetPanel::stopOutdatedSimulation() {
  m_simulation->stopOutdated();
}

void BudgetPanel::setEvaluation(const SharedEvaluation& evaluation) {
  const SessionFit& fit = evaluation->fit;
  m_simulation->setEvaluation(evaluation);
  m_intersection->setStatement(fit.intersection ? std::optional(fitBudget(fit)) : std::nullopt);
  m_centres->setStatement(centreBudget(fit));
  m_note->setVisible(fit.arcs.empty());
}

void BudgetPanel::setGap(const Gap& gap) {
  if (!gap.measured()) return clearGap();
  m_measured->setStatement(measuredBudget(*gap.diagnosis, gap.evaluation->examined.measurement->coverage));
}

/// Marks the budget as outdated; the contents below stay.
void BudgetPanel::setGapStale() {
  m_measured->setEnabled(false);
}

void BudgetPanel::clearGap() {
  m_measured->setStatement(std::nullopt);
}

}  // namespace alidade::ui
