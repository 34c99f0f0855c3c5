#pragma once

#include <QDialog>
#include <vector>

#include "ui/jobs/trial_job.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace alidade::ui {

class DataTable;
class GapHeadline;
class GapWaterfall;

/// Blind trials: a session is drawn from a plan and a truth that stays sealed, it is diagnosed, and then the
/// seal is opened and the diagnosis scored. Also many at a stretch, all opened.
class BlindTrialDialog : public QDialog {
  Q_OBJECT

 public:
  explicit BlindTrialDialog(QWidget* parent = nullptr);

  TrialJob& job() { return m_job; }
  const SharedTrial& current() const { return m_current; }

 signals:
  /// The session of the current trial is wanted in the window.
  void sessionWanted(const alidade::Session& session);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createChoices();
  QWidget* createAnswer();
  QWidget* createTruth();
  QWidget* createScores();
  QWidget* createButtons();
  BlindTrialOptions options() const;
  void draw(int count);
  void take(const SharedTrial& trial);
  void openSeal();
  void showTrial(const SharedTrial& trial, bool isOpen);
  void showTruth();
  void showScores();
  void showWork();
  void colorScore();

  TrialJob m_job;
  SharedTrial m_current;              ///< null before the first
  std::vector<SharedTrial> m_opened;  ///< the newest last
  bool m_isOpen = false, m_isSeries = false;
  int m_wanted = 0;

  QComboBox *m_plan, *m_kind, *m_visible;
  QSpinBox *m_seed, *m_count;
  QLabel *m_title, *m_truth, *m_score;
  GapHeadline* m_answer;
  GapWaterfall* m_waterfall;
  DataTable* m_trials;
  QLabel* m_summary;
  QProgressBar* m_progress;
  QPushButton *m_draw, *m_open, *m_inWindow, *m_series;
};

}  // namespace alidade::ui
