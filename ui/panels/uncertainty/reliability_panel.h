#pragma once

#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

#include "core/adjustment/joint/reliability.h"
#include "core/adjustment/result/input_reliability.h"
#include "ui/jobs/fit_job.h"

class QLabel;

namespace alidade::ui {

class DataTable;

/// How well the other readings check each reading: redundancy, standardised residual, smallest detectable
/// error, and the change of Δd if that error stays undetected. Numbers entered once, such as pointing zeros,
/// follow the readings. The selection is synchronised with the readings table.
class ReliabilityPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReliabilityPanel(QWidget* parent = nullptr);

  void setEvaluation(const SharedEvaluation& evaluation);
  /// Selects the row of a reading: indices into the session's positions and their readings.
  void setCurrentReading(std::size_t position, std::size_t row);

 signals:
  void sightingActivated(std::size_t position, std::size_t row);

 private:
  /// The row of a reading.
  struct Row {
    std::size_t position = 0, reading = 0;
    int axisDeg = 0, repeat = 1, round = 1, point = 0, face = 1;
    AdjustedReading adjusted;
    Reliability reliability;
  };

  const std::vector<AdjustedReading>& readings() const;
  const ArcMeasurement& measuredArc(const AdjustedReading& adjusted) const;
  /// Computes a row when it is painted, so a long table costs no more than its visible rows.
  Row row(int index) const;
  Row rowOf(const AdjustedReading& adjusted) const;
  Reliability reliability(const AdjustedReading& adjusted) const;
  /// The input in row `index` of the table; null if the row is a reading.
  const InputReliability* input(int index) const;
  DataTable* createTable();
  void showCurrent();

  SharedEvaluation m_evaluation;  ///< never null
  Detection m_detection;
  std::vector<InputReliability> m_inputs;
  std::optional<std::pair<std::size_t, std::size_t>> m_current;
  QLabel* m_summary;
  DataTable* m_table;
};

}  // namespace alidade::ui
