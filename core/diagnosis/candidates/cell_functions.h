#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace alidade {

// Functions over the cells of a carrier (pattern.h). Copies share their data, since many patterns use the
// same functions. The values are computed piece by piece.
class CellFunctions {
 public:
  /// `functions` is cells × functions, in single precision: no pattern is known more precisely.
  CellFunctions(Eigen::MatrixXf functions);
  /// Makes one function for each group: 1 in the cells of the group, 0 elsewhere. `groups` gives the group of
  /// each cell, from 0 to `count` − 1; −1 means none.
  CellFunctions(std::vector<Eigen::Index> groups, Eigen::Index count);

  Eigen::Index cells() const {
    return m_groups ? static_cast<Eigen::Index>(m_groups->size()) : m_all->rows();
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(m_chosen.size()); }
  /// Returns a copy that has only the functions with these indices.
  CellFunctions chosen(const std::vector<Eigen::Index>& functions) const;
  void scale(double factor) { m_factor *= factor; }

  Eigen::VectorXd column(Eigen::Index function) const;
  /// Returns the values in `length` cells from `first` on, cells × functions.
  Eigen::MatrixXd piece(Eigen::Index first, Eigen::Index length) const;
  Eigen::MatrixXd dense() const { return piece(0, cells()); }
  /// Returns the inner product of each function with a vector over the cells.
  Eigen::VectorXd products(const Eigen::VectorXd& overCells) const;
  /// Returns the weighted sum of the functions, one value for each cell.
  Eigen::VectorXd times(const Eigen::VectorXd& weights) const;

 private:
  std::shared_ptr<const Eigen::MatrixXf> m_all;
  std::shared_ptr<const std::vector<Eigen::Index>> m_groups;
  std::vector<Eigen::Index> m_chosen;  ///< selected columns of the matrix, or selected groups
  double m_factor = 1;
};

}  // namespace alidade
