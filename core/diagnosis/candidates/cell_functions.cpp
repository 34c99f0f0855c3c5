#include "core/diagnosis/candidates/cell_functions.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr Index pieceLength = 4096;  // cells at a time: the values of a few functions then fit into the cache

std::vector<Index> everyOf(Index count) {
  std::vector<Index> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), Index{0});
  return numbers;
}

}  // namespace

CellFunctions::CellFunctions(Eigen::MatrixXf functions)
    : m_all(std::make_shared<const Eigen::MatrixXf>(std::move(functions))),
      m_chosen(everyOf(m_all->cols())) {}

CellFunctions::CellFunctions(std::vector<Index> groups, Index count)
    : m_groups(std::make_shared<const std::vector<Index>>(std::move(groups))), m_chosen(everyOf(count)) {}

CellFunctions CellFunctions::chosen(const std::vector<Index>& functions) const {
  CellFunctions result = *this;
  result.m_chosen.clear();
  for (const Index function : functions)
    result.m_chosen.push_back(m_chosen[static_cast<std::size_t>(function)]);
  return result;
}

MatrixXd CellFunctions::piece(Index first, Index length) const {
  MatrixXd values(length, count());
  for (Index f = 0; f < values.cols(); ++f) {
    const Index own = m_chosen[static_cast<std::size_t>(f)];
    if (m_all)
      values.col(f) = m_all->col(own).segment(first, length).cast<double>() * m_factor;
    else
      for (Index i = 0; i < length; ++i)
        values(i, f) = (*m_groups)[static_cast<std::size_t>(first + i)] == own ? m_factor : 0;
  }
  return values;
}

VectorXd CellFunctions::column(Index function) const {
  return chosen({function}).dense();
}

VectorXd CellFunctions::products(const VectorXd& overCells) const {
  VectorXd sums = VectorXd::Zero(count());
  for (Index first = 0; first < cells(); first += pieceLength) {
    const Index length = std::min(pieceLength, cells() - first);
    const MatrixXd some = piece(first, length);
    sums.noalias() += some.transpose() * overCells.segment(first, length);
  }
  return sums;
}

VectorXd CellFunctions::times(const VectorXd& weights) const {
  VectorXd sum(cells());
  for (Index first = 0; first < cells(); first += pieceLength) {
    const Index length = std::min(pieceLength, cells() - first);
    sum.segment(first, length).noalias() = piece(first, length) * weights;
  }
  return sum;
}

}  // namespace alidade
