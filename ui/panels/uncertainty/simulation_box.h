#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/jobs/simulation_job.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace alidade::ui {

class StatementView;
class SessionDocument;

/// Checks the propagated uncertainty of Δd by Monte Carlo: a field for the draws, a button to run or stop,
/// both results, and whether they agree. A run requested after an edit waits for the fit of that edit.
class SimulationBox : public QWidget {
  Q_OBJECT

 public:
  explicit SimulationBox(const SessionDocument& document, QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// The session changed: stops a run whose input has changed.
  void stopOutdated();
  const SimulationJob& job() const { return m_job; }
  bool isWanted() const { return m_isWaiting || m_job.isAtWork(); }  ///< running or waiting

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
  SharedEvaluation m_simulated;  ///< the evaluation of the running simulation; null before the first
  SharedBudgetCheck m_check;     ///< the last successful check; null before the first
  QString m_remark;              ///< why the last run gave no result
  bool m_isWaiting = false;      ///< runs once the current session is fitted
  QTimer m_watch;
  QSpinBox* m_draws;
  QPushButton* m_run;
  QProgressBar* m_progress;
  StatementView* m_answer;
  QLabel* m_note;
};

}  // namespace alidade::ui
