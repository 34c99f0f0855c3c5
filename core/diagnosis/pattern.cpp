#include "core/diagnosis/pattern.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// oneᵀ other. Blocking a product with a few columns costs more than multiplying.
MatrixXd innerProducts(const MatrixXd& one, const MatrixXd& other) {
  constexpr Index few = 4;
  if (one.cols() <= few) return one.transpose().lazyProduct(other);
  return one.transpose() * other;
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
  return innerProducts(functions, m_taken);
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

void Pattern::normalise() {
  double moved = 0, square = 0;
  for (const auto& [carrier, functions] : parts) {
    moved += static_cast<double>(carrier->moved());
    square += carrier->squares().dot(functions.rowwise().squaredNorm());
  }
  for (Part& part : parts) part.functions *= std::sqrt(moved / square);
}

/// Columnsᵀ columns less what lies along the arc angle of each visit and in the span of the unknowns.
MatrixXd Pattern::visibleGram() const {
  const Index count = columns();
  MatrixXd gram = MatrixXd::Zero(count, count);
  MatrixXd along, taken;
  Index first = 0;
  for (const auto& [carrier, functions] : parts) {
    const Index own = functions.cols();
    const MatrixXd alongOwn = carrier->alongVisits(functions), takenOwn = carrier->taken(functions);
    along.conservativeResize(alongOwn.rows(), first + own);
    along.rightCols(own) = alongOwn;
    taken.conservativeResize(first + own, takenOwn.cols());
    taken.bottomRows(own) = takenOwn;
    Index before = 0;
    for (const auto& [other, others] : parts) {
      if (before > first) break;
      const VectorXd products = before == first ? carrier->squares() : other->productsWith(*carrier);
      gram.block(before, first, others.cols(), own) =
          innerProducts(others, products.asDiagonal() * functions);
      before += others.cols();
    }
    first += own;
  }
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
  return gram - innerProducts(along, along) - innerProducts(taken.transpose(), taken.transpose());
}

}  // namespace alidade
