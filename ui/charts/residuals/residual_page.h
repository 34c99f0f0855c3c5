#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;

namespace alidade::ui {

class ResidualChart;

/// The residual chart, below a row of entries for the kind of chart and the range of the residuals.
class ResidualPage : public QWidget {
  Q_OBJECT

 public:
  explicit ResidualPage(QWidget* parent = nullptr);

  ResidualChart* chart() const { return m_chart; }

 private:
  void addKinds();
  void takeReach();
  void showChoice();

  ResidualChart* m_chart;
  QComboBox* m_kind;
  QLineEdit* m_reach;
  QLabel* m_unit;
};

}  // namespace alidade::ui
