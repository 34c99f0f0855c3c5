#pragma once

#include <Eigen/Core>
#include <vector>

namespace alidade {

// Columns over the readings that are zero almost everywhere, or on all readings of a circle, for the .cpp
// files of this room only. Kept reading by reading, each with a run of neighbouring columns.
class SparseColumns {
 public:
  struct Run {
    Eigen::Index row;    ///< reading
    Eigen::Index first;  ///< column of the first value
    Eigen::Map<const Eigen::RowVectorXd> values;
  };

  SparseColumns() = default;
  explicit SparseColumns(Eigen::Index columns) : m_columns(columns) {}

  /// Rows in ascending order, each once.
  void add(Eigen::Index row, Eigen::Index first, const Eigen::RowVectorXd& values);
  void scale(double factor);

  Eigen::Index columns() const { return m_columns; }
  std::size_t runs() const { return m_runs.size(); }
  Run run(std::size_t i) const;
  double squaredNorm() const;
  /// Columnsᵀ times a vector over the readings.
  Eigen::VectorXd transposeTimes(const Eigen::VectorXd& overReadings) const;
  /// Columns times weights, over so many readings.
  Eigen::VectorXd times(const Eigen::VectorXd& weights, Eigen::Index readings) const;

 private:
  struct Place {
    Eigen::Index row, first, length;
    std::size_t begin;  ///< into m_values
  };
  Eigen::Index m_columns = 0;
  std::vector<Place> m_runs;
  std::vector<double> m_values;
};

}  // namespace alidade
