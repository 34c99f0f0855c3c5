#pragma once

#include <QWidget>
#include <vector>

#include "core/evaluation/gap.h"

class QLabel;
class QPushButton;

namespace alidade::ui {

class FormChart;

/// The forms of a gap: each in a sentence, with where the model holds and its curve; then how far the gap
/// shrinks.
class FormList : public QWidget {
  Q_OBJECT

 public:
  explicit FormList(QWidget* parent = nullptr);

  void setGap(const Gap& gap);

 signals:
  void keepWanted(std::size_t form);  ///< as an effect of one's own; an index into the forms

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
