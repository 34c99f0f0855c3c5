#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/candidates/component.h"
#include "core/diagnosis/candidates/jump_columns.h"

namespace alidade {

// The visible columns of every component that may explain a leftover, seen through their inner products.
// Columns of one component are turned so that each has inner products with its neighbours only. Behind the
// candidates' columns comes one for each reading, 1σ off. A bending component has its columns and
// curvature, not turned.
class ColumnTable {
 public:
  ColumnTable(const Leftover& leftover, const std::vector<Component>& candidates);

  Eigen::Index size() const { return m_size; }
  /// Of a candidate, or of a misreading numbered behind them.
  Eigen::Index first(std::size_t component) const {
    return component < m_candidates.size()
               ? m_first[component]
               : m_first.back() + static_cast<Eigen::Index>(component - m_candidates.size());
  }
  Eigen::Index count(std::size_t component) const {
    return component < m_candidates.size() ? m_first[component + 1] - m_first[component] : 1;
  }
  /// The squared length of every column.
  const Eigen::VectorXd& squares() const { return m_squares; }
  /// The inner product of every column with the next of its component.
  const Eigen::VectorXd& beside() const { return m_beside; }
  /// The inner products of a component's columns with one another.
  Eigen::MatrixXd gram(std::size_t component) const;
  /// The inner products of all columns with a vector that is visible, rows() long.
  Eigen::VectorXd products(const Eigen::VectorXd& visible) const;
  /// The same with each column of a component: size() × count.
  Eigen::MatrixXd productsOf(std::size_t component) const;
  /// Weights of turned columns as weights of the component.
  Eigen::VectorXd weights(std::size_t component, const Eigen::VectorXd& turned) const;

 private:
  const Leftover& m_leftover;
  const std::vector<Component>& m_candidates;
  std::vector<Eigen::Index> m_first;     ///< of each candidate, and of the readings
  std::vector<Eigen::MatrixXd> m_turns;  ///< empty: not turned
  Eigen::Index m_size = 0;
  Eigen::VectorXd m_squares, m_beside;
  JumpColumns m_steps;

  void turn(std::size_t component);
  Eigen::MatrixXd turnedColumns(std::size_t component) const;
};

}  // namespace alidade
