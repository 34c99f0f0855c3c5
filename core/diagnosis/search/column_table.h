#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// Inner products of the visible columns of all components. The columns of a component are rotated so that
// each has inner products with its neighbours only. A bent component keeps its columns and second
// derivatives, unrotated.
class ColumnTable {
 public:
  ColumnTable(const Leftover& leftover, const Candidates& candidates);

  Eigen::Index size() const { return m_first.back(); }
  Eigen::Index first(std::size_t component) const { return m_first[component]; }
  Eigen::Index count(std::size_t component) const { return first(component + 1) - first(component); }
  /// Squared length of every column.
  const Eigen::VectorXd& squares() const { return m_squares; }
  /// Inner product of every column with the next column of its component.
  const Eigen::VectorXd& subdiagonal() const { return m_subdiagonal; }
  /// Gram matrix of a component's columns.
  Eigen::MatrixXd gram(std::size_t component) const;
  /// Inner products of all columns with a visible vector, `rows()` long.
  Eigen::VectorXd products(const Eigen::VectorXd& visible) const;
  /// Inner products of all columns with each column of a component: `size()` × count.
  Eigen::MatrixXd productsOf(std::size_t component) const;
  /// Converts weights of turned columns into weights of the component.
  Eigen::VectorXd weights(std::size_t component, const Eigen::VectorXd& turned) const;

 private:
  const Leftover& m_leftover;
  const Candidates& m_candidates;
  // 32 bits suffice: `limits::mostRows` bounds the number of rows.
  std::vector<std::uint32_t> m_first;              ///< first column of each component, and the end
  std::map<std::size_t, Eigen::MatrixXd> m_turns;  ///< rotations of the turned components
  Eigen::VectorXd m_squares, m_subdiagonal;

  void turn(std::size_t component);
};

}  // namespace alidade
