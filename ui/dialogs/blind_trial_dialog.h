#pragma once

#include <QDialog>

#include "ui/jobs/trial_job.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace alidade::ui {

class GapHeadline;
class StatementView;
class TrialList;

/// Runs blind trials: simulates a session from a plan and a sealed truth, and diagnoses the session. Opening
/// the seal scores the diagnosis. A series of trials opens every seal. Sealed trials stay in the list.
class BlindTrialDialog : public QDialog {
  Q_OBJECT

 public:
  explicit BlindTrialDialog(QWidget* parent = nullptr);

  TrialJob& job() { return m_job; }
  const SharedTrial& current() const { return m_current; }

 signals:
  /// Asks the window to show the session of the current trial.
  void sessionWanted(const alidade::Session& session);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createChoices();
  QWidget* createAnswer();
  QWidget* createTruth();
  QWidget* createTrials();
  QWidget* createButtons();
  BlindTrialOptions options() const;
  void draw(int count);
  void take(const SharedTrial& trial);
  void openSeal();
  void showTrial(const SharedTrial& trial);
  void showTruth();
  void showWork();
  void colorScore();

  TrialJob m_job;
  SharedTrial m_current;  ///< the trial shown; null before the first
  bool m_isOpen = false, m_isSeries = false;

  QWidget* m_choices;
  QComboBox *m_plan, *m_kind, *m_visible;
  QSpinBox *m_seed, *m_count;
  QLabel *m_title, *m_truth, *m_score;
  GapHeadline* m_answer;
  StatementView* m_stages;
  TrialList* m_trials;
  QProgressBar* m_progress;
  QPushButton *m_draw, *m_open, *m_inWindow, *m_series;
};

}  // namespace alidade::ui
