#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace alidade {

// Functions over the cells of a carrier (pattern.h). Patterns have many of them in common: copies share
// what they were made of, and are written out piece by piece.
class CellFunctions {
 public:
  /// Cells × functions; in single precision, as no pattern is known better.
  CellFunctions(Eigen::MatrixXf functions);
  /// A function for each group: 1 in its cells, 0 elsewhere. `groups`: of each cell, numbered from 0 to
  /// `count`; −1 for none.
  CellFunctions(std::vector<Eigen::Index> groups, Eigen::Index count);

  Eigen::Index cells() const {
    return m_groups ? static_cast<Eigen::Index>(m_groups->size()) : m_all->rows();
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(m_chosen.size()); }
  /// Only those of these functions.
  CellFunctions chosen(const std::vector<Eigen::Index>& functions) const;
  void scale(double factor) { m_factor *= factor; }

  Eigen::VectorXd column(Eigen::Index function) const;
  /// The values in `length` cells, cells × functions.
  Eigen::MatrixXd piece(Eigen::Index first, Eigen::Index length) const;
  Eigen::MatrixXd dense() const { return piece(0, cells()); }
  /// Of each function: its inner product with a vector over the cells.
  Eigen::VectorXd products(const Eigen::VectorXd& overCells) const;
  /// Their sum with these weights, over the cells.
  Eigen::VectorXd times(const Eigen::VectorXd& weights) const;

 private:
  std::shared_ptr<const Eigen::MatrixXf> m_all;
  std::shared_ptr<const std::vector<Eigen::Index>> m_groups;
  std::vector<Eigen::Index> m_chosen;  ///< columns of the matrix, or groups
  double m_factor = 1;
};

}  // namespace alidade
