#include "ui/panels/uncertainty/budget_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/wording/across.h"
#include "core/wording/budget.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/uncertainty/simulation_box.h"
#include "ui/text/budget_text.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

BudgetPanel::BudgetPanel(const SessionDocument& document, QWidget* parent)
    : ScrollPage(tr("Budget"), parent),
      m_measuredTitle(panelHeading(tr("Standard uncertainty of Δd, measured"))),
      m_measured(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_measuredNote(wrappedLabel()),
      m_intersectionTitle(panelHeading(tr("Standard uncertainty of Δd, fit only"))),
      m_intersection(new FigureGrid),
      m_simulation(new SimulationBox(document)),
      m_centresTitle(panelHeading(tr("Standard uncertainty of the centres  mm"))),
      m_centres(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_note(new QLabel) {
  m_note->setWordWrap(true);
  for (QLabel* note : {m_note, m_measuredNote}) note->setForegroundRole(QPalette::PlaceholderText);
  QVBoxLayout* layout = column();
  layout->addWidget(m_measuredTitle);
  layout->addWidget(m_measured);
  layout->addWidget(m_measuredNote);
  layout->addWidget(m_intersectionTitle);
  layout->addWidget(m_intersection);
  layout->addWidget(m_simulation);
  layout->addWidget(m_centresTitle);
  layout->addWidget(m_centres);
  layout->addSpacing(6);
  layout->addWidget(m_note);
  layout->addStretch();
  clearGap();
  connect(m_simulation, &SimulationBox::checked, this, &BudgetPanel::checked);
}

void BudgetPanel::stopOutdatedSimulation() {
  m_simulation->stopOutdated();
}

void BudgetPanel::setEvaluation(const SharedEvaluation& evaluation) {
  const SessionFit& fit = evaluation->fit;
  m_simulation->setEvaluation(evaluation);
  showIntersection(fit);
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
  showMeasured(gap.measured());
  if (!gap.measured()) return;
  QStringList notes{
      tr("1σ: how large each effect may plausibly be; share: of the variance. A: by the scatter of these "
         "readings; B: by other knowledge."),
      qText(acrossSentence(*gap.measured()))};
  if (const QString attainable = attainableText(gap); !attainable.isEmpty()) notes.append(attainable);
  m_measuredNote->setText(notes.join(u'\n'));
}

/// Marks the budget as outdated; the contents below stay.
void BudgetPanel::setGapStale() {
  for (QWidget* part : std::initializer_list<QWidget*>{m_measuredTitle, m_measured, m_measuredNote})
    part->setEnabled(false);
}

void BudgetPanel::clearGap() {
  showMeasured(nullptr);
}

void BudgetPanel::showMeasured(const MeasuredIntersection* measured) {
  for (QWidget* part : std::initializer_list<QWidget*>{m_measuredTitle, m_measured, m_measuredNote}) {
    part->setEnabled(true);
    part->setVisible(measured);
  }
  if (!measured) return;
  const IntersectionEstimate& found = measured->estimate;
  QVector<FigureGrid::Row> rows;
  for (const BudgetLine& line : budgetLines(*measured))
    rows.append({line.source,
                 {line.sizes, line.type, numberText(line.sigma, 4), shareText(line.sigma, found.sigma)},
                 line.from.isEmpty() ? QString() : tr("Size from: %1").arg(line.from)});
  rows.append({tr("combined, u"), {{}, {}, numberText(found.sigma, 4), {}}});
  rows.append({tr("expanded, U"),
               {{}, {}, numberText(found.expanded, 4), {}},
               tr("%1 effective degrees of freedom").arg(degreesOfFreedomText(found.degreesOfFreedom))});
  m_measured->setRows({tr("1σ"), tr("type"), tr("mm"), tr("share")}, rows);
}

void BudgetPanel::showIntersection(const SessionFit& fit) {
  QVector<FigureGrid::Row> rows;
  if (fit.intersection) {
    for (const BudgetEntry& entry : fit.intersection->budget)
      rows.append({qText(textOf(entry.source)),
                   {numberText(entry.sigma, 4), shareText(entry.sigma, fit.intersection->sigma)}});
    rows.append({tr("combined, u"), {numberText(fit.intersection->sigma, 4), {}}});
    rows.append({tr("expanded, U"),
                 {numberText(fit.intersection->expanded, 4), {}},
                 tr("k σ with k = %1").arg(numberText(fit.intersection->coverageFactor, 2))});
  }
  m_intersectionTitle->setVisible(!rows.isEmpty());
  m_intersection->setVisible(!rows.isEmpty());
  m_intersection->setRows({tr("mm"), tr("of variance")}, rows);
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
