#include "core/diagnosis/column_table.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/diagnosis/known_components.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Eigenvectors of a symmetric matrix of two rows: a turn of the axes.
Eigen::Matrix2d turnOfTwo(const MatrixXd& gram) {
  const double angle = std::atan2(2 * gram(0, 1), gram(0, 0) - gram(1, 1)) / 2;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return turn;
}

}  // namespace

ColumnTable::ColumnTable(const Leftover& leftover, const std::vector<Component>& candidates)
    : m_leftover(leftover),
      m_candidates(candidates),
      m_steps(leftover, momentsOf(candidates), plausibleJump) {
  Index ofEffects = 0;
  for (const Component& candidate : candidates) {
    m_first.push_back(m_size);
    m_size += candidate.gram.cols() + candidate.curvature.cols();
    assert(candidate.kind != Component::Kind::Effect || ofEffects == m_first.back());
    if (candidate.kind == Component::Kind::Effect) ofEffects = m_size;
  }
  m_first.push_back(m_size);
  m_size += leftover.readings();
  m_squares.resize(m_size);
  m_turns.resize(candidates.size());
  m_carriersOf.resize(candidates.size());
  m_effects.resize(leftover.rows(), ofEffects);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    turn(i);
    if (candidates[i].kind == Component::Kind::Effect) addEffect(i);
    if (candidates[i].kind == Component::Kind::Shape) addPattern(i);
  }
  for (Index i = 0; i < leftover.readings(); ++i) m_squares[m_first.back() + i] = leftover.redundancy(i);
}

void ColumnTable::turn(std::size_t component) {
  const Component& candidate = m_candidates[component];
  if (candidate.curvature.cols() > 0) return;
  auto squares = m_squares.segment(first(component), count(component));
  const MatrixXd& gram = candidate.gram;
  if (gram.cols() == 1) {
    squares = gram.col(0);
  } else if (gram.cols() == 2) {
    const Eigen::Matrix2d turn = turnOfTwo(gram);
    squares = (turn.transpose() * gram.topLeftCorner<2, 2>() * turn).diagonal();
    m_turns[component] = turn;
  } else {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
    squares = eigen.eigenvalues();
    m_turns[component] = eigen.eigenvectors();
  }
}

void ColumnTable::addEffect(std::size_t component) {
  const Component& candidate = m_candidates[component];
  auto columns = m_effects.middleCols(first(component), count(component));
  if (candidate.curvature.cols() > 0) {
    columns = bentColumns(candidate);
    m_bentGram = columns.transpose() * columns;
    m_squares.segment(first(component), count(component)) = m_bentGram.diagonal();
  } else if (m_turns[component].size() > 0) {
    columns = candidate.columns.lazyProduct(m_turns[component]);
  } else {
    columns = candidate.columns;
  }
}

void ColumnTable::addPattern(std::size_t component) {
  for (const Pattern::Part& part : m_candidates[component].pattern.parts) {
    const auto known = std::ranges::find(m_carriers, part.carrier);
    m_carriersOf[component].push_back(static_cast<std::size_t>(known - m_carriers.begin()));
    if (known == m_carriers.end()) m_carriers.push_back(part.carrier);
  }
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
  VectorXd all = VectorXd::Zero(m_size);
  const VectorXd readings = visible.head(m_leftover.readings());
  all.head(m_effects.cols()).noalias() = m_effects.transpose() * visible;
  const Eigen::Matrix2Xd steps = m_steps.products(readings);
  Index step = 0;
  for (std::size_t i = 0; i < m_candidates.size(); ++i)
    if (m_candidates[i].kind == Component::Kind::Jump)
      all.segment<2>(first(i)).noalias() =
          m_turns[i].topLeftCorner<2, 2>().transpose().lazyProduct(steps.col(step++));
  std::vector<VectorXd> ofCells;
  for (const auto& carrier : m_carriers) ofCells.push_back(carrier->gathered(readings));
  for (std::size_t i = 0; i < m_candidates.size(); ++i) {
    if (m_candidates[i].kind != Component::Kind::Shape) continue;
    auto own = all.segment(first(i), count(i));
    Index row = 0;
    for (std::size_t p = 0; p < m_carriersOf[i].size(); ++p) {
      const MatrixXd& functions = m_candidates[i].pattern.parts[p].functions;
      own.segment(row, functions.cols()).noalias() = functions.transpose() * ofCells[m_carriersOf[i][p]];
      row += functions.cols();
    }
    if (m_turns[i].size() > 0) own = m_turns[i].transpose() * own;
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
  if (candidate.kind == Component::Kind::Effect)
    return m_effects.middleCols(first(component), count(component));
  const MatrixXd columns = m_leftover.visible(wholeColumns(m_leftover, candidate));
  return m_turns[component].size() > 0 ? MatrixXd(columns * m_turns[component]) : columns;
}

}  // namespace alidade
