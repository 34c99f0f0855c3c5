#include "core/diagnosis/search/column_table.h"

#include <algorithm>
#include <utility>

#include "core/diagnosis/candidates/known_components.h"
#include "core/diagnosis/search/gain.h"

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
  m_beside.setZero(m_size);
  m_turns.resize(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) turn(i);
  for (Index i = 0; i < leftover.readings(); ++i) m_squares[m_first.back() + i] = leftover.redundancy(i);
}

void ColumnTable::turn(std::size_t component) {
  const Component& candidate = m_candidates[component];
  if (candidate.curvature.cols() > 0) {
    m_squares.segment(first(component), count(component)) = candidate.bentGram.diagonal();
    return;
  }
  if (candidate.gram.cols() <= 2) {  // tridiagonal as it is
    m_squares.segment(first(component), count(component)) = candidate.gram.diagonal();
    if (candidate.gram.cols() == 2) m_beside[first(component)] = candidate.gram(0, 1);
    return;
  }
  Tridiagonal turn = tridiagonalOf(candidate.gram);
  m_squares.segment(first(component), count(component)) = turn.diagonal;
  m_beside.segment(first(component), turn.subdiagonal.size()) = turn.subdiagonal;
  m_turns[component] = std::move(turn.matrix);
}

MatrixXd ColumnTable::gram(std::size_t component) const {
  if (component < m_candidates.size() && m_candidates[component].curvature.cols() > 0)
    return m_candidates[component].bentGram;
  MatrixXd gram = m_squares.segment(first(component), count(component)).asDiagonal();
  const auto beside = m_beside.segment(first(component), count(component) - 1);
  gram.diagonal(1) = gram.diagonal(-1) = beside;
  return gram;
}

VectorXd ColumnTable::products(const VectorXd& visible) const {
  VectorXd all(m_size);
  const VectorXd readings = visible.head(m_leftover.readings());
  const Eigen::Matrix2Xd steps = m_steps.products(readings);
  Index step = 0;
  for (std::size_t i = 0; i < m_candidates.size(); ++i)
    if (m_candidates[i].kind == Component::Kind::Jump) all.segment<2>(first(i)) = steps.col(step++);
  const VectorXd ofTerms = m_leftover.productsOfTerms(visible);
  std::vector<std::pair<const Carrier*, VectorXd>> gathered;  // patterns share carriers
  const auto gatheredBy = [&](const Carrier* carrier) -> const VectorXd& {
    const auto known = std::ranges::find(gathered, carrier, &std::pair<const Carrier*, VectorXd>::first);
    return known != gathered.end() ? known->second
                                   : gathered.emplace_back(carrier, carrier->gathered(readings)).second;
  };
  for (std::size_t i = 0; i < m_candidates.size(); ++i) {
    auto own = all.segment(first(i), count(i));
    if (m_candidates[i].kind == Component::Kind::Effect)
      own = productsWith(visible, ofTerms, m_candidates[i]);
    Index row = 0;
    for (const auto& [carrier, functions] : m_candidates[i].pattern.parts) {
      own.segment(row, functions.count()) = functions.products(gatheredBy(carrier.get()));
      row += functions.count();
    }
    if (m_turns[i].size() > 0) own = m_turns[i].transpose() * own;
  }
  all.tail(m_leftover.readings()) = readings;
  return all;
}

MatrixXd ColumnTable::productsOf(std::size_t component) const {
  const MatrixXd columns = turnedColumns(component);
  MatrixXd all(m_size, columns.cols());
  for (Index c = 0; c < columns.cols(); ++c) all.col(c) = products(columns.col(c));
  return all;
}

VectorXd ColumnTable::weights(std::size_t component, const VectorXd& turned) const {
  if (component >= m_candidates.size() || m_turns[component].size() == 0) return turned;
  return m_turns[component] * turned;
}

MatrixXd ColumnTable::turnedColumns(std::size_t component) const {
  if (component >= m_candidates.size()) {
    VectorXd unit = VectorXd::Zero(m_leftover.readings());
    unit[static_cast<Index>(component - m_candidates.size())] = 1;
    return m_leftover.visible(unit);
  }
  const MatrixXd columns = visibleColumns(m_leftover, m_candidates[component]);
  return m_turns[component].size() > 0 ? MatrixXd(columns * m_turns[component]) : columns;
}

}  // namespace alidade
