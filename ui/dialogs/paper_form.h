#pragma once

#include <QWidget>
#include <array>

#include "ui/report/report_paper.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace alidade::ui {

class FormDraft;

/// Entries for paper and margins.
class PaperForm : public QWidget {
  Q_OBJECT

 public:
  explicit PaperForm(const ReportPaper& paper, QWidget* parent = nullptr);

  ReportPaper paper() const;
  /// Keeps the unconfirmed choice in `draft` until the form is accepted.
  void keepIn(FormDraft& draft);
  /// Adds a row below the others, aligned with them.
  void addRow(QLabel* label, QWidget* entry);

 private:
  QComboBox* m_size;
  std::array<QDoubleSpinBox*, 4> m_margins;  ///< left, top, right, bottom
};

/// Asks for paper and margins in a dialog of their own. False: cancelled.
bool askPaper(QWidget* parent, ReportPaper& paper);

}  // namespace alidade::ui
