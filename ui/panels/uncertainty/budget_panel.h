#pragma once

#include "core/evaluation/gap.h"
#include "ui/jobs/simulation_job.h"
#include "ui/panels/parts/scroll_page.h"

class QLabel;

namespace alidade::ui {

class SessionDocument;
class SimulationBox;
class StatementView;

/// The uncertainty budgets. That of Δd, measured, lists every effect of the catalogue. Those of Δd, fit only,
/// and of each centre coordinate list readings, model effects, known radius, pointing zeros and distance.
/// Checks the fit by Monte Carlo on request.
class BudgetPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit BudgetPanel(const SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// The diagnosis of the current session.
  void setGap(const Gap& gap);
  /// The session changed: the budget of Δd, measured, is marked as outdated.
  void setGapStale();
  /// Hides the budget of Δd, measured, for another session, which is not diagnosed yet.
  void clearGap();
  /// The session changed: stops a Monte Carlo run whose input has changed.
  void stopOutdatedSimulation();

 signals:
  void checked(const alidade::ui::SharedBudgetCheck& check);

 private:
  StatementView* m_measured;
  StatementView* m_intersection;
  SimulationBox* m_simulation;
  StatementView* m_centres;
  QLabel* m_note;
};

}  // namespace alidade::ui
