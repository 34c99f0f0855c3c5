#pragma once

#include <QWidget>
#include <vector>

#include "core/simulation/trial_summary.h"
#include "ui/jobs/trial_job.h"

class QLabel;

namespace alidade::ui {

class DataTable;

/// Every trial drawn, the newest first, with its truth where the seal is open and without where it is not;
/// above them the score of those that are open. The trial of the current row is the one to be shown.
class TrialList : public QWidget {
  Q_OBJECT

 public:
  explicit TrialList(QWidget* parent = nullptr);

  /// The new one becomes current unless another one was chosen since the draw began. To choose the newest of
  /// a series is to follow it.
  void add(const SharedTrial& trial);
  void openSeal(const SharedTrial& trial);
  bool isOpen(const SharedTrial& trial) const;
  /// No row is current, and each new trial becomes so until one is chosen. Those of a series are open.
  void beginDraw(bool isSeries);
  void clearChoice();  ///< no row is current

 signals:
  void chosen(const alidade::ui::SharedTrial& trial);  ///< its row became current

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
  Tally m_right, m_falseAlarms, m_covered;        ///< of those with their seals open
  bool m_isSeries = false, m_isFollowing = true;  ///< the latter: a new one becomes current
  QLabel* m_summary;
  DataTable* m_table;
};

}  // namespace alidade::ui
