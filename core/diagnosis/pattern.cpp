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

/// Adds factor columnsᵀ columns to the upper half of a matrix. Without rows that is nothing, which Eigen 3.4
/// must not be asked: its blocking of a rank update with 48 columns and more divides by the number of rows.
template <typename Matrix>
void addSquare(Matrix&& sum, const MatrixXd& columns, double factor) {
  if (columns.rows() == 0) return;
  if (columns.cols() <= few)
    sum += factor * columns.transpose().lazyProduct(columns);
  else
    sum.template selfadjointView<Eigen::Upper>().rankUpdate(columns.transpose(), factor);
}

/// The Gram matrix, of which the upper half is given, less what lies along the arc angles and in the span of
/// the unknowns.
MatrixXd visiblePart(MatrixXd gram, const MatrixXd& along, const MatrixXd& taken) {
  addSquare(gram, along, -1);
  addSquare(gram, taken, -1);
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
  return gram;
}

}  // namespace

Carrier::Carrier(const Leftover& leftover, const VectorXd& values, const std::vector<Index>& cells)
    : m_leftover(&leftover),
      m_readings(values.size()),
      m_visitCount(static_cast<Index>(leftover.visits().size())) {
  const Index count = cells.empty() ? 0 : cells.back() + 1;
  m_squares = m_along = VectorXd::Zero(count);
  m_visits.resize(static_cast<std::size_t>(count));
  m_moved.reserve(cells.size());
  for (Index i = 0; i < values.size(); ++i) {
    const LinearReading& reading = leftover.reading(i);
    const Index cell = cells[static_cast<std::size_t>(i)];
    m_visits[static_cast<std::size_t>(cell)] = static_cast<std::uint32_t>(reading.visit);
    if (values[i] == 0) continue;
    m_moved.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(cell), values[i]});
    m_squares[cell] += values[i] * values[i];
    m_along[cell] += values[i] * reading.along;
  }
  if (count == m_visitCount) m_squaresOutside = (m_squares - m_along.cwiseAbs2()).cwiseMax(0);
}

VectorXd Carrier::gathered(const VectorXd& overReadings) const {
  VectorXd sums = VectorXd::Zero(cells());
  for (const auto& [reading, cell, value] : m_moved) sums[cell] += value * overReadings[reading];
  return sums;
}

VectorXd Carrier::spread(const VectorXd& overCells) const {
  VectorXd readings = VectorXd::Zero(m_readings);
  for (const auto& [reading, cell, value] : m_moved) readings[reading] = value * overCells[cell];
  return readings;
}

MatrixXd Carrier::alongVisits(const MatrixXd& functions) const {
  MatrixXd sums = MatrixXd::Zero(m_visitCount, functions.cols());
  for (Index f = 0; f < functions.cols(); ++f)
    for (Index cell = 0; cell < cells(); ++cell) sums(visitOf(cell), f) += m_along[cell] * functions(cell, f);
  return sums;
}

MatrixXd Carrier::taken(const MatrixXd& functions) const {
  constexpr Index pieceLength = 512;  // readings: what they spread to stays in the cache
  MatrixXd sums = MatrixXd::Zero(unknowns(), functions.cols());
  auto next = m_moved.begin();
  for (Index first = 0; first < m_readings; first += pieceLength) {
    MatrixXd spread = MatrixXd::Zero(std::min(pieceLength, m_readings - first), functions.cols());
    for (; next != m_moved.end() && next->reading < first + spread.rows(); ++next)
      spread.row(next->reading - first) = next->value * functions.row(next->cell);
    sums += innerProducts(m_leftover->basis().middleRows(first, spread.rows()), spread);
  }
  return sums;
}

MatrixXd Carrier::visibleGramOfGroups(const std::vector<Index>& groups, Index count) const {
  const bool hasOneCellPerVisit = m_squaresOutside.size() > 0;
  const VectorXd& squares = hasOneCellPerVisit ? m_squaresOutside : m_squares;
  MatrixXd gram = MatrixXd::Zero(count, count), taken = MatrixXd::Zero(unknowns(), count);
  for (Index cell = 0; cell < cells(); ++cell) {
    const Index group = groups[static_cast<std::size_t>(cell)];
    if (group < 0) continue;
    gram(group, group) += squares[cell];
  }
  for (const auto& [reading, cell, value] : m_moved)
    if (const Index group = groups[cell]; group >= 0)
      taken.col(group) += value * m_leftover->basisOfRow(reading);
  if (!hasOneCellPerVisit) takeOffAlongVisits(gram, groups);
  return visiblePart(std::move(gram), MatrixXd(0, count), taken);
}

/// In pieces: a group for every visit would fill the memory.
void Carrier::takeOffAlongVisits(MatrixXd& gram, const std::vector<Index>& groups) const {
  constexpr Index pieceLength = 4096;  // visits
  Index cell = 0;
  for (Index first = 0; first < m_visitCount; first += pieceLength) {
    MatrixXd along = MatrixXd::Zero(std::min(pieceLength, m_visitCount - first), gram.cols());
    for (; cell < cells() && visitOf(cell) < first + along.rows(); ++cell)
      if (const Index group = groups[static_cast<std::size_t>(cell)]; group >= 0)
        along(visitOf(cell) - first, group) += m_along[cell];
    addSquare(gram, along, -1);
  }
}

VectorXd Carrier::productsWith(const Carrier& other) const {
  assert(m_visits == other.m_visits);
  return gathered(other.spread(VectorXd::Ones(cells())));
}

Index Pattern::columns() const {
  Index sum = 0;
  for (const Part& part : parts) sum += part.functions.count();
  return sum;
}

VectorXd Pattern::times(const VectorXd& weights) const {
  VectorXd sum;
  Index first = 0;
  for (const auto& [carrier, functions] : parts) {
    const VectorXd own = carrier->spread(functions.times(weights.segment(first, functions.count())));
    sum = sum.size() == 0 ? own : VectorXd(sum + own);
    first += functions.count();
  }
  return sum;
}

double Pattern::normalise() {
  double moved = 0, square = 0;
  for (const auto& [carrier, functions] : parts) {
    moved += static_cast<double>(carrier->moved());
    for (Index f = 0; f < functions.count(); ++f)
      square += (functions.column(f).array().square() * carrier->squares().array()).sum();
  }
  if (square == 0) return 0;
  const double factor = std::sqrt(moved / square);
  for (Part& part : parts) part.functions.scale(factor);
  return factor;
}

/// Columnsᵀ columns less what lies along the arc angle of each visit and in the span of the unknowns.
MatrixXd Pattern::visibleGram() const {
  const Index count = columns(), visits = parts.front().carrier->visits(),
              unknowns = parts.front().carrier->unknowns();
  const bool isOfVisits = parts.size() == 1 && parts.front().carrier->squaresOutsideArcAngles().size() > 0;
  MatrixXd gram = MatrixXd::Zero(count, count), along = MatrixXd::Zero(isOfVisits ? 0 : visits, count),
           taken(unknowns, count);
  Index first = 0;
  for (const auto& [carrier, ofPart] : parts) {
    MatrixXd functions = ofPart.dense();
    const Index own = functions.cols();
    const VectorXd& squares = isOfVisits ? carrier->squaresOutsideArcAngles() : carrier->squares();
    if (!isOfVisits) along.middleCols(first, own) = carrier->alongVisits(functions);
    taken.middleCols(first, own) = carrier->taken(functions);
    Index before = 0;
    for (const auto& [other, others] : parts) {
      if (before == first) break;
      gram.block(before, first, others.count(), own) =
          innerProducts(others.dense(), other->productsWith(*carrier).asDiagonal() * functions);
      before += others.count();
    }
    functions = squares.cwiseSqrt().asDiagonal() * functions;
    addSquare(gram.block(first, first, own, own), functions, 1);
    first += own;
  }
  return visiblePart(std::move(gram), along, taken);
}

}  // namespace alidade
