#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/jobs/simulation_job.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace alidade::ui {

class FigureGrid;
class SessionDocument;

/// The propagated uncertainty of Δd checked by simulation: how many draws, run or stop, and both side by side
/// with whether they agree. Shows figures only of the session as it is, and simulates no other: a run that is
/// wanted after an edit begins when the edit is fitted.
class SimulationBox : public QWidget {
  Q_OBJECT

 public:
  explicit SimulationBox(const SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// The session has changed: stops what is at work where that is no longer of it.
  void stopOutdated();
  const SimulationJob& job() const { return m_job; }
  bool isWanted() const { return m_isWaiting || m_job.isAtWork(); }  ///< at work, or about to be

 signals:
  void checked(const alidade::ui::SharedBudgetCheck& check);

 private:
  void createControls();
  void toggle();
  void start();
  void take(const SharedBudgetCheck& check);
  void showWork();
  void showCheck();

  const SessionDocument& m_document;
  SimulationJob m_job;
  SharedEvaluation m_evaluation;
  SharedEvaluation m_simulated;  ///< what is at work is of this one; null before the first
  SharedBudgetCheck m_check;     ///< the last that came to something; null before
  QString m_remark;              ///< what became of the last run, where it came to nothing
  bool m_isWaiting = false;      ///< to be run when the session as it is has been fitted
  QTimer m_watch;
  QSpinBox* m_draws;
  QPushButton* m_run;
  QProgressBar* m_progress;
  FigureGrid* m_figures;
  QLabel* m_note;
};

}  // namespace alidade::ui
