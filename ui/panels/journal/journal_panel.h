#pragma once

#include <QWidget>

#include "ui/jobs/fit_job.h"

class QLabel;

namespace alidade::ui {

class DataTable;

/// Recorded changes, newest first: when, by whom, what, old and new text, and why.
class JournalPanel : public QWidget {
  Q_OBJECT

 public:
  explicit JournalPanel(QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// Shows the summary, which is known once the search for misread readings has ended.
  void setSummary(const Evaluation& evaluation);

 private:
  const JournalEntry& entry(int row) const;
  DataTable* createTable();

  SharedEvaluation m_evaluation;  ///< never null
  QLabel* m_summary;
  DataTable* m_table;
};

}  // namespace alidade::ui
