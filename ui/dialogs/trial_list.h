#pragma once

#include <QWidget>
#include <vector>

#include "core/simulation/trial_summary.h"
#include "ui/jobs/trial_job.h"

class QLabel;

namespace alidade::ui {

class DataTable;

/// A list of all trials, newest first, with the truth of opened trials. The score of the opened trials is
/// above the list. The dialog shows the trial of the current row.
class TrialList : public QWidget {
  Q_OBJECT

 public:
  explicit TrialList(QWidget* parent = nullptr);

  /// Adds a trial. It becomes current unless the user chose another since the draw began. After the user
  /// chooses the newest trial of a series, new trials become current again.
  void add(const SharedTrial& trial);
  void openSeal(const SharedTrial& trial);
  bool isOpen(const SharedTrial& trial) const;
  /// Clears the current row; each new trial becomes current until the user chooses a trial. `isSeries`: new
  /// trials are opened at once.
  void beginDraw(bool isSeries);
  void clearChoice();  ///< no row is current afterwards

 signals:
  void chosen(const alidade::ui::SharedTrial& trial);  ///< the trial whose row became current

 private:
  struct Drawn {
    SharedTrial trial;
    bool isOpen = false;
  };

  DataTable* createTable();
  const Drawn& atRow(int row) const { return m_drawn[m_drawn.size() - 1 - static_cast<std::size_t>(row)]; }
  void score(const DiagnosedTrial& trial);
  void showScore();

  std::vector<Drawn> m_drawn;                     ///< the newest last
  Tally m_right, m_falseAlarms, m_covered;        ///< counts over the opened trials
  bool m_isSeries = false, m_isFollowing = true;  ///< `m_isFollowing`: a new trial becomes current
  QLabel* m_summary;
  DataTable* m_table;
};

}  // namespace alidade::ui
