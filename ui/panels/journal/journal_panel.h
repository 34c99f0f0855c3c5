#pragma once

#include <QWidget>

#include "ui/jobs/fit_job.h"

class QLabel;

namespace alidade::ui {

class DataTable;

/// What was changed after it stood, the newest first: when, by whom, what, from what to what, and why.
class JournalPanel : public QWidget {
  Q_OBJECT

 public:
  explicit JournalPanel(QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// What it comes to, which is known once misread readings are searched for.
  void setSummary(const Evaluation& evaluation);

 private:
  const JournalEntry& entry(int row) const;
  DataTable* createTable();

  SharedEvaluation m_evaluation;  ///< never null
  QLabel* m_summary;
  DataTable* m_table;
};

}  // namespace alidade::ui
