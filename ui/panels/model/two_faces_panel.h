#pragma once

#include <QWidget>
#include <vector>

#include "core/evaluation/evaluation.h"

namespace alidade::ui {

class DataTable;
class StatementView;

/// The two-face table: collimation, trunnion tilt and index from the differences of the faces, then every
/// visit that was read in both faces.
class TwoFacesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TwoFacesPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);

 signals:
  void sightingActivated(std::size_t position, std::size_t row);

 private:
  struct Row {
    std::size_t position = 0, reading = 0;
    int axisDeg = 0, repeat = 1, round = 1, point = 0;
    FaceDifference difference;
  };

  const Row& row(int index) const { return m_rows[static_cast<std::size_t>(index)]; }
  DataTable* createTable();

  std::vector<Row> m_rows;
  StatementView* m_errors;
  DataTable* m_table;
};

}  // namespace alidade::ui
