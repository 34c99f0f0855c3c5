#pragma once

#include <QWidget>
#include <vector>

#include "core/evaluation/gap.h"

class QLabel;
class QPushButton;

namespace alidade::ui {

class FormChart;

/// The forms of a gap: for each a sentence, the range in which the model is valid, and the curve. Then a
/// sentence on how far the gap shrinks.
class FormList : public QWidget {
  Q_OBJECT

 public:
  explicit FormList(QWidget* parent = nullptr);

  void setGap(const Gap& gap);

 signals:
  void keepWanted(std::size_t form);  ///< keep form `form` (index) as an effect of one's own

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
