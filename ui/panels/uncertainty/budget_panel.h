#pragma once

#include "ui/jobs/simulation_job.h"
#include "ui/panels/parts/scroll_page.h"

class QLabel;

namespace alidade::ui {

class FigureGrid;
class SessionDocument;
class SimulationBox;

/// Where the uncertainty comes from: readings, model effects, pointing zeros and distance, for Δd and for
/// each coordinate of the centres. Checked by simulation where that is wanted.
class BudgetPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit BudgetPanel(const SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// The session has changed: stops a simulation at work where that is no longer of it.
  void stopOutdatedSimulation();

 signals:
  void checked(const alidade::ui::SharedBudgetCheck& check);

 private:
  void showIntersection(const SessionFit& fit);
  void showCentres(const SessionFit& fit);

  QLabel* m_intersectionTitle;
  FigureGrid* m_intersection;
  SimulationBox* m_simulation;
  QLabel* m_centresTitle;
  FigureGrid* m_centres;
  QLabel* m_note;
};

}  // namespace alidade::ui
