#include "core/diagnosis/candidates/pattern.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr Index few = 4;  // columns; up to this number, a blocked product costs more than a plain one

/// Returns oneᵀ other.
MatrixXd innerProducts(const MatrixXd& one, const MatrixXd& other) {
  if (std::min(one.cols(), other.cols()) <= few) return one.transpose().lazyProduct(other);
  return one.transpose() * other;
}

/// Adds factor × columnsᵀ columns to the upper half of a matrix. Does nothing without rows: Eigen 3.4 divides
/// by the number of rows when it blocks a rank update with 48 or more columns.
template <typename Matrix>
void addSquare(Matrix&& sum, const MatrixXd& columns, double factor) {
  if (columns.rows() == 0) return;
  if (columns.cols() <= few)
    sum += factor * columns.transpose().lazyProduct(columns);
  else
    sum.template selfadjointView<Eigen::Upper>().rankUpdate(columns.transpose(), factor);
}

/// Returns the Gram matrix without the span of the unknowns. Only the upper half of `gram` needs to be set.
MatrixXd visiblePart(MatrixXd gram, const MatrixXd& taken) {
  addSquare(gram, taken, -1);
  gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
  return gram;
}

}  // namespace

Carrier::Carrier(const Leftover& leftover, const VectorXd& values, std::shared_ptr<const Cells> cells)
    : m_cells(std::move(cells)) {
  m_squares = m_along = VectorXd::Zero(m_cells->count());
  m_moved.reserve(static_cast<std::size_t>((values.array() != 0).count()));
  for (Index i = 0; i < values.size(); ++i) {
    const Moved moved{static_cast<std::uint32_t>(i), static_cast<float>(values[i])};
    if (moved.value == 0) continue;
    const double value = moved.value;
    m_moved.push_back(moved);
    m_squares[cellOf(moved)] += value * value;
    m_along[cellOf(moved)] += value * leftover.reading(i).along;
  }
}

VectorXd Carrier::squaresOutsideArcAngles(const Leftover& leftover) const {
  if (cells() != leftover.visits()) return {};
  return (m_squares - m_along.cwiseAbs2()).cwiseMax(0);
}

VectorXd Carrier::gathered(const VectorXd& overReadings) const {
  VectorXd sums = VectorXd::Zero(cells());
  for (const Moved& moved : m_moved) sums[cellOf(moved)] += moved.value * overReadings[moved.reading];
  return sums;
}

VectorXd Carrier::spread(const VectorXd& overCells) const {
  VectorXd spread = VectorXd::Zero(readings());
  for (const Moved& moved : m_moved) spread[moved.reading] = moved.value * overCells[cellOf(moved)];
  return spread;
}

MatrixXd Carrier::alongVisits(const Leftover& leftover, Index first, const MatrixXd& functions) const {
  if (functions.rows() == 0) return MatrixXd(0, functions.cols());
  const Index firstVisit = visitOf(leftover, first);
  MatrixXd sums =
      MatrixXd::Zero(visitOf(leftover, first + functions.rows() - 1) - firstVisit + 1, functions.cols());
  for (Index f = 0; f < functions.cols(); ++f)
    for (Index i = 0; i < functions.rows(); ++i)
      sums(visitOf(leftover, first + i) - firstVisit, f) += m_along[first + i] * functions(i, f);
  return sums;
}

MatrixXd Carrier::taken(const Leftover& leftover, Index first, const MatrixXd& functions) const {
  constexpr Index pieceLength = 512;  // readings whose spread values fit into the cache
  MatrixXd sums = MatrixXd::Zero(leftover.basis().cols(), functions.cols());
  if (functions.rows() == 0) return sums;
  const Index last = first + functions.rows(), end = last < cells() ? m_cells->readingOf(last) : readings();
  Index begin = m_cells->readingOf(first);
  auto next = std::ranges::lower_bound(m_moved, begin, {}, &Moved::reading);
  for (; begin < end; begin += pieceLength) {
    MatrixXd spread = MatrixXd::Zero(std::min(pieceLength, end - begin), functions.cols());
    for (; next != m_moved.end() && next->reading < begin + spread.rows(); ++next)
      spread.row(next->reading - begin) = next->value * functions.row(cellOf(*next) - first);
    sums += innerProducts(leftover.basis().middleRows(begin, spread.rows()), spread);
  }
  return sums;
}

Index Carrier::lastOfVisit(const Leftover& leftover, Index cell) const {
  const Index visit = visitOf(leftover, cell);
  while (cell + 1 < cells() && visitOf(leftover, cell + 1) == visit) ++cell;
  return cell;
}

MatrixXd Carrier::visibleGramOfGroups(const Leftover& leftover, const std::vector<Index>& groups,
                                      Index count) const {
  const VectorXd outside = squaresOutsideArcAngles(leftover);
  const bool hasOneCellPerVisit = outside.size() > 0;
  const VectorXd& squares = hasOneCellPerVisit ? outside : m_squares;
  MatrixXd gram = MatrixXd::Zero(count, count), taken = MatrixXd::Zero(leftover.basis().cols(), count);
  for (Index cell = 0; cell < cells(); ++cell) {
    const Index group = groups[static_cast<std::size_t>(cell)];
    if (group < 0) continue;
    gram(group, group) += squares[cell];
  }
  for (const Moved& moved : m_moved)
    if (const Index group = groups[cellOf(moved)]; group >= 0)
      taken.col(group) += moved.value * leftover.basisOfRow(moved.reading);
  if (!hasOneCellPerVisit) takeOffAlongVisits(leftover, gram, groups);
  return visiblePart(std::move(gram), taken);
}

/// Works in pieces: a matrix of visits × groups can fill the memory.
void Carrier::takeOffAlongVisits(const Leftover& leftover, MatrixXd& gram,
                                 const std::vector<Index>& groups) const {
  constexpr Index pieceLength = 4096;  // visits
  Index cell = 0;
  for (Index first = 0; first < leftover.visits(); first += pieceLength) {
    MatrixXd along = MatrixXd::Zero(std::min(pieceLength, leftover.visits() - first), gram.cols());
    for (; cell < cells() && visitOf(leftover, cell) < first + along.rows(); ++cell)
      if (const Index group = groups[static_cast<std::size_t>(cell)]; group >= 0)
        along(visitOf(leftover, cell) - first, group) += m_along[cell];
    addSquare(gram, along, -1);
  }
}

VectorXd Carrier::productsWith(const Carrier& other) const {
  assert(m_cells->ofReadings == other.m_cells->ofReadings);
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

MatrixXd Pattern::piece(Index firstCell, Index length) const {
  MatrixXd side(length, columns());
  Index first = 0;
  for (const Part& part : parts) {
    side.middleCols(first, part.functions.count()) = part.functions.piece(firstCell, length);
    first += part.functions.count();
  }
  return side;
}

/// Returns the Gram matrix without the arc angle of each visit and the span of the unknowns. Works in pieces:
/// the functions of every cell can fill the memory.
MatrixXd Pattern::visibleGram(const Leftover& leftover) const {
  constexpr Index pieceLength = 4096;  // cells
  const Index count = columns();
  const VectorXd outside =
      parts.size() == 1 ? parts.front().carrier->squaresOutsideArcAngles(leftover) : VectorXd();
  const bool isOfVisits = outside.size() > 0;
  struct Product {
    Index columns;  // number of columns of the first of two parts
    VectorXd sums;
  };
  std::vector<Product> products;
  for (std::size_t one = 0; one < parts.size(); ++one)
    for (std::size_t other = 0; other < one; ++other)
      products.push_back(
          {parts[other].functions.count(), parts[other].carrier->productsWith(*parts[one].carrier)});
  MatrixXd gram = MatrixXd::Zero(count, count), taken = MatrixXd::Zero(leftover.basis().cols(), count);
  const Index cells = parts.empty() ? 0 : parts.front().functions.cells();
  for (Index begin = 0, end = 0; begin < cells; begin = end) {
    end = parts.front().carrier->lastOfVisit(leftover, std::min(begin + pieceLength, cells) - 1) + 1;
    const MatrixXd functions = piece(begin, end - begin);
    MatrixXd along(0, count);
    auto product = products.begin();
    Index first = 0;
    for (const auto& [carrier, ofPart] : parts) {
      const MatrixXd own = functions.middleCols(first, ofPart.count());
      taken.middleCols(first, own.cols()) += carrier->taken(leftover, begin, own);
      if (!isOfVisits) {
        const MatrixXd sums = carrier->alongVisits(leftover, begin, own);
        along.conservativeResize(sums.rows(), count);
        along.middleCols(first, own.cols()) = sums;
      }
      for (Index before = 0; before < first; ++product) {
        const MatrixXd others = functions.middleCols(before, product->columns);
        const MatrixXd weighted = product->sums.segment(begin, end - begin).asDiagonal() * own;
        gram.block(before, first, others.cols(), own.cols()) += innerProducts(others, weighted);
        before += others.cols();
      }
      const auto squares = (isOfVisits ? outside : carrier->squares()).segment(begin, end - begin);
      addSquare(gram.block(first, first, own.cols(), own.cols()), squares.cwiseSqrt().asDiagonal() * own, 1);
      first += own.cols();
    }
    addSquare(gram, along, -1);
  }
  return visiblePart(std::move(gram), taken);
}

}  // namespace alidade
