#include "core/diagnosis/pattern.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr Index few = 4;  // blocking a product with fewer columns costs more than multiplying

/// oneᵀ other.
MatrixXd innerProducts(const MatrixXd& one, const MatrixXd& other) {
  if (std::min(one.cols(), other.cols()) <= few) return one.transpose().lazyProduct(other);
  return one.transpose() * other;
}

/// Adds factor columnsᵀ columns to the upper half of a matrix.
template <typename Matrix>
void addSquare(Matrix&& sum, const MatrixXd& columns, double factor) {
  if (columns.cols() <= few)
    sum += factor * columns.transpose().lazyProduct(columns);
  else
    sum.template selfadjointView<Eigen::Upper>().rankUpdate(columns.transpose(), factor);
}

}  // namespace

Carrier::Carrier(const Leftover& leftover, VectorXd values, std::vector<Index> cells)
    : m_values(std::move(values)),
      m_cells(std::move(cells)),
      m_visitCount(static_cast<Index>(leftover.visits().size())) {
  const Index count = m_cells.empty() ? 0 : m_cells.back() + 1;
  m_squares = m_along = VectorXd::Zero(count);
  m_visits.resize(static_cast<std::size_t>(count));
  MatrixXd taken = MatrixXd::Zero(leftover.basis().cols(), count);
  for (Index i = 0; i < m_values.size(); ++i) {
    const LinearReading& reading = leftover.reading(i);
    const Index cell = m_cells[static_cast<std::size_t>(i)];
    m_visits[static_cast<std::size_t>(cell)] = static_cast<Index>(reading.visit);
    if (m_values[i] == 0) continue;
    m_squares[cell] += m_values[i] * m_values[i];
    m_along[cell] += m_values[i] * reading.along;
    taken.col(cell) += m_values[i] * leftover.basisOfRow(i);
  }
  m_taken = taken.transpose();
  m_moved = (m_values.array() != 0).count();
  if (count == m_visitCount) m_squaresOutside = (m_squares - m_along.cwiseAbs2()).cwiseMax(0);
}

VectorXd Carrier::gathered(const VectorXd& overReadings) const {
  VectorXd sums = VectorXd::Zero(cells());
  for (Index i = 0; i < m_values.size(); ++i)
    sums[m_cells[static_cast<std::size_t>(i)]] += m_values[i] * overReadings[i];
  return sums;
}

VectorXd Carrier::spread(const VectorXd& overCells) const {
  VectorXd readings(m_values.size());
  for (Index i = 0; i < readings.size(); ++i)
    readings[i] = m_values[i] * overCells[m_cells[static_cast<std::size_t>(i)]];
  return readings;
}

MatrixXd Carrier::alongVisits(const MatrixXd& functions) const {
  MatrixXd sums = MatrixXd::Zero(m_visitCount, functions.cols());
  for (Index f = 0; f < functions.cols(); ++f)
    for (Index cell = 0; cell < cells(); ++cell)
      sums(m_visits[static_cast<std::size_t>(cell)], f) += m_along[cell] * functions(cell, f);
  return sums;
}

MatrixXd Carrier::taken(const MatrixXd& functions) const {
  return innerProducts(m_taken, functions);
}

MatrixXd Carrier::visibleGramOfGroups(const std::vector<Index>& groups, Index count) const {
  const bool hasOneCellPerVisit = m_squaresOutside.size() > 0;
  MatrixXd gram = MatrixXd::Zero(count, count), taken = MatrixXd::Zero(unknowns(), count),
           along = MatrixXd::Zero(hasOneCellPerVisit ? 0 : m_visitCount, count);
  for (Index cell = 0; cell < cells(); ++cell) {
    const Index group = groups[static_cast<std::size_t>(cell)];
    if (group < 0) continue;
    gram(group, group) += hasOneCellPerVisit ? m_squaresOutside[cell] : m_squares[cell];
    if (!hasOneCellPerVisit) along(m_visits[static_cast<std::size_t>(cell)], group) += m_along[cell];
    taken.col(group) += m_taken.row(cell).transpose();
  }
  addSquare(gram, along, -1);
  addSquare(gram, taken, -1);
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
  return gram;
}

VectorXd Carrier::productsWith(const Carrier& other) const {
  assert(m_cells == other.m_cells);
  return gathered(other.m_values);
}

Index Pattern::columns() const {
  Index sum = 0;
  for (const Part& part : parts) sum += part.functions.cols();
  return sum;
}

VectorXd Pattern::times(const VectorXd& weights) const {
  VectorXd sum;
  Index first = 0;
  for (const auto& [carrier, functions] : parts) {
    const VectorXd own = carrier->spread(functions * weights.segment(first, functions.cols()));
    sum = sum.size() == 0 ? own : VectorXd(sum + own);
    first += functions.cols();
  }
  return sum;
}

double Pattern::normalise() {
  double moved = 0, square = 0;
  for (const auto& [carrier, functions] : parts) {
    moved += static_cast<double>(carrier->moved());
    for (Index f = 0; f < functions.cols(); ++f)
      square += functions.col(f).cwiseAbs2().dot(carrier->squares());
  }
  if (square == 0) return 0;
  const double factor = std::sqrt(moved / square);
  for (Part& part : parts) part.functions *= factor;
  return factor;
}

/// Columnsᵀ columns less what lies along the arc angle of each visit and in the span of the unknowns.
MatrixXd Pattern::visibleGram() const {
  const Index count = columns(), visits = parts.front().carrier->visits(),
              unknowns = parts.front().carrier->unknowns();
  MatrixXd gram = MatrixXd::Zero(count, count), along = MatrixXd::Zero(visits, count), taken(unknowns, count);
  Index first = 0;
  for (const auto& [carrier, functions] : parts) {
    const Index own = functions.cols();
    const bool hasOneCellPerVisit = parts.size() == 1 && carrier->squaresOutsideArcAngles().size() > 0;
    const VectorXd& squares = hasOneCellPerVisit ? carrier->squaresOutsideArcAngles() : carrier->squares();
    if (!hasOneCellPerVisit) along.middleCols(first, own) = carrier->alongVisits(functions);
    taken.middleCols(first, own) = carrier->taken(functions);
    addSquare(gram.block(first, first, own, own), squares.cwiseSqrt().asDiagonal() * functions, 1);
    Index before = 0;
    for (const auto& [other, others] : parts) {
      if (before == first) break;
      gram.block(before, first, others.cols(), own) =
          innerProducts(others, other->productsWith(*carrier).asDiagonal() * functions);
      before += others.cols();
    }
    first += own;
  }
  addSquare(gram, along, -1);
  addSquare(gram, taken, -1);
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
  return gram;
}

}  // namespace alidade
