#pragma once

#include <QWidget>
#include <vector>

#include "core/evaluation/gap.h"

class QLabel;
class QPushButton;

namespace alidade::ui {

class FormChart;

/// Shows each form of a gap: a sentence, the range in which the model is valid without the form, and the
/// curve. Below them, a sentence says how far the gap shrinks.
class FormList : public QWidget {
  Q_OBJECT

 public:
  explicit FormList(QWidget* parent = nullptr);

  void setGap(const Gap& gap);

 signals:
  void keepWanted(std::size_t form);  ///< asks to keep the form with this index as the user's own effect

 private:
  struct Row {
    QLabel *sentence, *about;
    FormChart* chart;
    QPushButton* keep;
  };

  std::vector<Row> m_rows;
  QLabel* m_shrinkage;
};

}  // namespace alidade::ui
