#pragma once

#include "ui/jobs/gap.h"
#include "ui/jobs/simulation_job.h"
#include "ui/panels/parts/scroll_page.h"

class QLabel;

namespace alidade::ui {

class FigureGrid;
class SessionDocument;
class SimulationBox;

/// Where the uncertainty comes from: for Δd as it was measured, every effect of the catalogue; for Δd of the
/// fit alone and for each coordinate of the centres, readings, model effects, pointing zeros and distance.
/// The fit checked by simulation where that is wanted.
class BudgetPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit BudgetPanel(const SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// What the diagnosis of the session as it is found.
  void setGap(const Gap& gap);
  /// The session has changed: what is said of the measurement is of before.
  void setGapStale();
  /// Another session: nothing is known of its measurement yet.
  void clearGap();
  /// The session has changed: stops a simulation at work where that is no longer of it.
  void stopOutdatedSimulation();

 signals:
  void checked(const alidade::ui::SharedBudgetCheck& check);

 private:
  void showMeasured(const MeasuredIntersection* measured);
  void showIntersection(const SessionFit& fit);
  void showCentres(const SessionFit& fit);

  QLabel* m_measuredTitle;
  FigureGrid* m_measured;
  QLabel* m_measuredNote;
  QLabel* m_intersectionTitle;
  FigureGrid* m_intersection;
  SimulationBox* m_simulation;
  QLabel* m_centresTitle;
  FigureGrid* m_centres;
  QLabel* m_note;
};

}  // namespace alidade::ui
