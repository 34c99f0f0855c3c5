#include "ui/panels/uncertainty/budget_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "core/statement/budget.h"
#include "core/wording/budget.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/panels/uncertainty/simulation_box.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

BudgetPanel::BudgetPanel(const SessionDocument& document, QWidget* parent)
    : ScrollPage(tr("Budget"), parent),
      m_measured(new StatementView),
      m_intersection(new StatementView),
      m_simulation(new SimulationBox(document)),
      m_centresTitle(panelHeading(tr("Standard uncertainty of the centres  mm"))),
      m_centres(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_note(new QLabel) {
  m_note->setWordWrap(true);
  m_note->setForegroundRole(QPalette::PlaceholderText);
  QVBoxLayout* layout = column();
  layout->addWidget(m_measured);
  layout->addWidget(m_intersection);
  layout->addWidget(m_simulation);
  layout->addWidget(m_centresTitle);
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
  m_intersection->setStatement(fit.intersection ? std::optional(fitBudget(*fit.intersection)) : std::nullopt);
  showCentres(fit);
  const QString scale =
      std::isfinite(fit.noise.degreesOfFreedom)
          ? tr("What comes from the readings is scaled by their scatter, %1 times the stated noise. Pointing "
               "zeros and distance enter as stated.")
                .arg(numberText(fit.noise.factor, 2))
          : tr("All parts rest on the stated noise.");
  m_note->setText(fit.arcs.empty() ? tr("No arc is fitted yet, so there is nothing to account for.") : scale);
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

void BudgetPanel::showCentres(const SessionFit& fit) {
  QVector<FigureGrid::Row> rows;
  QStringList titles;
  const auto addColumn = [&](const QString& title, const std::vector<BudgetEntry>& budget,
                             double withRadius) {
    titles.append(title);
    rows.resize(static_cast<int>(budget.size()) + 2);
    for (std::size_t i = 0; i < budget.size(); ++i) {
      rows[static_cast<int>(i)].caption = qText(textOf(budget[i].source));
      rows[static_cast<int>(i)].figures.append(numberText(budget[i].sigma, 4));
    }
    rows[static_cast<int>(budget.size())].figures.append(numberText(combined(budget), 4));
    rows.back().figures.append(signedNumberText(withRadius, 2));
  };
  for (std::size_t arc = 0; arc < fit.budgets.size(); ++arc) {
    const int axis = fit.arcs[arc].axisDeg;
    if (&fit.arcs[arc] != fit.arcAt(axis)) continue;  // a repeat has the same centre
    addColumn(QStringLiteral("Δx %1°").arg(axis), fit.budgets[arc].x, fit.sigmas[arc].radiusX);
    addColumn(QStringLiteral("Δy %1°").arg(axis), fit.budgets[arc].y, fit.sigmas[arc].radiusY);
  }
  if (!rows.isEmpty()) {
    rows[rows.size() - 2].caption = tr("combined, u");
    rows.back().caption = tr("correlation with R");
    rows.back().toolTip =
        tr("How far a wrong radius takes the centre along, −1 to 1: on half an arc it decides the height");
  }
  m_centresTitle->setVisible(!rows.isEmpty());
  m_centres->setVisible(!rows.isEmpty());
  m_centres->setRows(titles, rows);
}

}  // namespace alidade::ui
