#include "core/diagnosis/search/column_table.h"

#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

ColumnTable::ColumnTable(const Leftover& leftover, const Candidates& candidates)
    : m_leftover(leftover), m_candidates(candidates) {
  m_first.reserve(candidates.size() + 1);
  m_first.push_back(0);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    m_first.push_back(m_first.back() + static_cast<std::uint32_t>(candidates[i].columns()));
  m_squares.resize(size());
  m_subdiagonal.setZero(size());
  for (std::size_t i = 0; i < candidates.size(); ++i) turn(i);
}

void ColumnTable::turn(std::size_t component) {
  const auto gram = m_candidates[component].gram();
  auto squares = m_squares.segment(first(component), count(component));
  const bool bends = m_candidates[component].response() == Response::Bent;
  if (bends || gram.cols() <= 2) {  // bent: not to be turned; two columns: already tridiagonal
    squares = gram.diagonal();
    if (gram.cols() == 2) m_subdiagonal[first(component)] = gram(0, 1);
    return;
  }
  Tridiagonal turn = tridiagonalOf(gram);
  squares = turn.diagonal;
  m_subdiagonal.segment(first(component), turn.subdiagonal.size()) = turn.subdiagonal;
  m_turns[component] = std::move(turn.matrix);
}

MatrixXd ColumnTable::gram(std::size_t component) const {
  if (m_candidates[component].response() == Response::Bent) return m_candidates[component].gram();
  MatrixXd gram = m_squares.segment(first(component), count(component)).asDiagonal();
  const auto next = m_subdiagonal.segment(first(component), count(component) - 1);
  gram.diagonal(1) = gram.diagonal(-1) = next;
  return gram;
}

VectorXd ColumnTable::products(const VectorXd& visible) const {
  VectorXd all(size());
  m_candidates.fillProducts(SharedProducts(m_leftover, visible), all);
  for (const auto& [component, turn] : m_turns) {
    auto own = all.segment(first(component), count(component));
    own = turn.transpose() * own;
  }
  return all;
}

MatrixXd ColumnTable::productsOf(std::size_t component) const {
  MatrixXd columns = m_candidates[component].visibleColumns(m_leftover);
  if (const auto turn = m_turns.find(component); turn != m_turns.end()) columns *= turn->second;
  MatrixXd all(size(), columns.cols());
  for (Index c = 0; c < columns.cols(); ++c) all.col(c) = products(columns.col(c));
  return all;
}

VectorXd ColumnTable::weights(std::size_t component, const VectorXd& turned) const {
  const auto turn = m_turns.find(component);
  return turn == m_turns.end() ? turned : VectorXd(turn->second * turned);
}

}  // namespace alidade
