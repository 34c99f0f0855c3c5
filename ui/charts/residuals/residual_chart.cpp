#include "ui/charts/residuals/residual_chart.h"

#include <QMenu>

#include "core/evaluation/evaluation.h"
#include "ui/charts/plotting/row_choice.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {

ResidualChart::ResidualChart(QWidget* parent) : ResidualChart(new ResidualPlot, parent) {}

ResidualChart::ResidualChart(ResidualPlot* plot, QWidget* parent)
    : PlotWidget(std::unique_ptr<Plot>(plot), parent), m_plot(plot) {
  setAccessibleName(tr("Residuals"));
  m_plot->setChoice(keptResidualChoice());
  setEvaluation({});
}

void ResidualChart::choose(const ResidualChoice& choice) {
  keep(choice);
  m_plot->setChoice(choice);
  updateDescriptions();
  emit chosen();
}

void ResidualChart::addChoices(QMenu& menu) {
  using Over = ResidualChoice::Over;
  menu.addSeparator();
  const ResidualChoice& now = m_plot->choice();
  QMenu& unit = *menu.addMenu(tr("&Unit"));
  unit.setEnabled(now.over != Over::Normal);
  for (const bool isStandardised : {false, true})
    addChoice(unit, isStandardised ? tr("&Standardised") : tr("&Arcseconds"),
              now.showsStandardised() == isStandardised, [this, now, isStandardised] {
                ResidualChoice choice = now;
                choice.isStandardised = isStandardised;
                choose(choice);
              });
  addCircles(*menu.addMenu(tr("&Circles")));
  addRowChoices(menu, m_plot->picture().kinds, now.rows.among(m_plot->picture().kinds),
                [this, now](const RowChoice& rows) {
                  ResidualChoice choice = now;
                  choice.rows = rows;
                  choose(choice);
                });
}

/// Adds the choice of circles, of which at least one is always drawn.
void ResidualChart::addCircles(QMenu& menu) {
  const std::pair<QString, bool ResidualChoice::*> circles[] = {
      {tr("&Horizontal"), &ResidualChoice::horizontal},
      {tr("&Vertical"), &ResidualChoice::vertical},
      {tr("&Slider"), &ResidualChoice::slider}};
  const ResidualChoice& now = m_plot->choice();
  const int drawn = int{now.horizontal} + int{now.vertical} + int{now.slider};
  for (const auto& [text, circle] : circles)
    addChoice(menu, text, now.*circle, [this, now, circle = circle] {
      ResidualChoice choice = now;
      choice.*circle = !(now.*circle);
      choose(choice);
    })->setEnabled(drawn > 1 || !(now.*circle));
}

}  // namespace alidade::ui
