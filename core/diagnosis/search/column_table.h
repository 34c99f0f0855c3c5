#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// The visible columns of every component that may explain a leftover, seen through their inner products.
// Columns of one component are turned so that each has inner products with its neighbours only. A bending
// component has its columns and second derivatives, not turned.
class ColumnTable {
 public:
  ColumnTable(const Leftover& leftover, const Candidates& candidates);

  Eigen::Index size() const { return m_first.back(); }
  Eigen::Index first(std::size_t component) const { return m_first[component]; }
  Eigen::Index count(std::size_t component) const { return first(component + 1) - first(component); }
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
  const Candidates& m_candidates;
  // There are no more rows than `limits::mostRows`.
  std::vector<std::uint32_t> m_first;              ///< of each component, and behind the last
  std::map<std::size_t, Eigen::MatrixXd> m_turns;  ///< of those that are turned
  Eigen::VectorXd m_squares, m_beside;

  void turn(std::size_t component);
};

}  // namespace alidade
