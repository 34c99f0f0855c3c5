#include "core/diagnosis/column_table.h"

#include <Eigen/Eigenvalues>

#include "core/diagnosis/known_components.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

ColumnTable::ColumnTable(const Leftover& leftover, const std::vector<Component>& candidates)
    : m_leftover(leftover),
      m_candidates(candidates),
      m_steps(leftover, momentsOf(candidates), plausibleJump) {
  for (const Component& candidate : candidates) {
    m_first.push_back(m_size);
    m_size += candidate.gram.cols() + candidate.curvature.cols();
  }
  m_first.push_back(m_size);
  m_size += leftover.readings();
  m_squares.resize(m_size);
  m_turns.resize(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto squares = m_squares.segment(first(i), count(i));
    if (candidates[i].curvature.cols() > 0) {
      const MatrixXd columns = bentColumns(candidates[i]);
      m_bentGram = columns.transpose() * columns;
      squares = m_bentGram.diagonal();
    } else if (candidates[i].gram.cols() == 1) {
      squares = candidates[i].gram.col(0);
    } else {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(candidates[i].gram);
      squares = eigen.eigenvalues();
      m_turns[i] = eigen.eigenvectors();
    }
  }
  for (Index i = 0; i < leftover.readings(); ++i) m_squares[m_first.back() + i] = leftover.redundancy(i);
}

Index ColumnTable::first(std::size_t component) const {
  return component < m_candidates.size()
             ? m_first[component]
             : m_first.back() + static_cast<Index>(component - m_candidates.size());
}

Index ColumnTable::count(std::size_t component) const {
  return component < m_candidates.size() ? m_first[component + 1] - m_first[component] : 1;
}

MatrixXd ColumnTable::gram(std::size_t component) const {
  if (component < m_candidates.size() && m_candidates[component].curvature.cols() > 0) return m_bentGram;
  return m_squares.segment(first(component), count(component)).asDiagonal();
}

VectorXd ColumnTable::products(const VectorXd& visible) const {
  VectorXd all(m_size);
  const auto readings = visible.head(m_leftover.readings());
  const Eigen::Matrix2Xd steps = m_steps.products(readings);
  Index step = 0;
  for (std::size_t i = 0; i < m_candidates.size(); ++i) {
    const Component& candidate = m_candidates[i];
    VectorXd own;
    if (candidate.curvature.cols() > 0)
      own = bentColumns(candidate).transpose() * visible;
    else if (candidate.kind == Component::Kind::Jump)
      own = steps.col(step++);
    else if (candidate.kind == Component::Kind::Shape)
      own = candidate.pattern.transposeTimes(readings);
    else
      own = candidate.columns.transpose() * visible;
    all.segment(first(i), count(i)) = m_turns[i].size() > 0 ? VectorXd(m_turns[i].transpose() * own) : own;
  }
  all.tail(m_leftover.readings()) = readings;
  return all;
}

MatrixXd ColumnTable::productsOf(std::size_t component) const {
  const MatrixXd columns = visibleColumns(component);
  MatrixXd all(columns.cols(), m_size);
  for (Index c = 0; c < columns.cols(); ++c) all.row(c) = products(columns.col(c)).transpose();
  return all;
}

VectorXd ColumnTable::weights(std::size_t component, const VectorXd& turned) const {
  if (component >= m_candidates.size() || m_turns[component].size() == 0) return turned;
  return m_turns[component] * turned;
}

MatrixXd ColumnTable::visibleColumns(std::size_t component) const {
  if (component >= m_candidates.size()) {
    VectorXd unit = VectorXd::Zero(m_leftover.readings());
    unit[static_cast<Index>(component - m_candidates.size())] = 1;
    return m_leftover.visible(unit);
  }
  const Component& candidate = m_candidates[component];
  if (candidate.curvature.cols() > 0) return bentColumns(candidate);
  const MatrixXd columns = candidate.kind == Component::Kind::Jump
                               ? m_leftover.visible(wholeColumns(m_leftover, candidate))
                               : candidate.columns;
  return m_turns[component].size() > 0 ? MatrixXd(columns * m_turns[component]) : columns;
}

}  // namespace alidade
