#pragma once

#include <QWidget>
#include <array>

#include "ui/report/report_paper.h"

class QComboBox;
class QDoubleSpinBox;

namespace alidade::ui {

/// Entries for paper and margins.
class PaperForm : public QWidget {
  Q_OBJECT

 public:
  explicit PaperForm(const ReportPaper& paper, QWidget* parent = nullptr);

  ReportPaper paper() const;

 private:
  QComboBox* m_size;
  std::array<QDoubleSpinBox*, 4> m_margins;  ///< left, top, right, bottom
};

/// Paper and margins alone, for the menu. False: cancelled.
bool askPaper(QWidget* parent, ReportPaper& paper);

}  // namespace alidade::ui
