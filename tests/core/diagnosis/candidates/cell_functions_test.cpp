#include "core/diagnosis/candidates/cell_functions.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/base/random_source.h"
#include "tests/support/full_leftover.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixXf, Eigen::VectorXd;
using test::greatest;

/// Three pieces, the last one short; one full piece; one full piece and one cell; a few cells.
constexpr Index cellCounts[] = {9001, 4096, 4097, 5};

MatrixXf drawnFunctions(Index cells, Index count) {
  RandomSource random(static_cast<std::uint64_t>(cells));
  return MatrixXf::NullaryExpr(cells, count, [&] { return static_cast<float>(random.normal()); });
}

VectorXd drawnVector(Index size) {
  RandomSource random(static_cast<std::uint64_t>(size), 1);
  return VectorXd::NullaryExpr(size, [&] { return random.normal(); });
}

/// Functions of no group and of four groups in turn, with the matrix of their values.
std::pair<std::vector<Index>, MatrixXd> fourGroups(Index cells) {
  std::vector<Index> groups;
  MatrixXd indicators = MatrixXd::Zero(cells, 4);
  for (Index cell = 0; cell < cells; ++cell) {
    groups.push_back((7 * cell + cell / 10) % 5 - 1);
    if (groups.back() >= 0) indicators(cell, groups.back()) = 1;
  }
  return {groups, indicators};
}

/// Sums of some thousand products of numbers near 1, in a different order.
void expectFunctions(const CellFunctions& functions, const MatrixXd& columns) {
  const double rounding = 1e-14 * static_cast<double>(columns.rows());
  ASSERT_EQ(functions.cells(), columns.rows());
  ASSERT_EQ(functions.count(), columns.cols());
  EXPECT_EQ(functions.dense(), columns);
  for (Index f = 0; f < columns.cols(); ++f) EXPECT_EQ(functions.column(f), columns.col(f)) << f;
  const VectorXd overCells = drawnVector(columns.rows()), weights = drawnVector(columns.cols());
  EXPECT_LT(greatest(functions.products(overCells) - columns.transpose() * overCells), rounding);
  EXPECT_LT(greatest(functions.times(weights) - columns * weights), rounding);
}

TEST(CellFunctions, AreTheColumnsOfTheirMatrixWhateverItsLength) {
  for (const Index cells : cellCounts) {
    SCOPED_TRACE(cells);
    const MatrixXf functions = drawnFunctions(cells, 3);
    expectFunctions(functions, functions.cast<double>());
  }
}

TEST(CellFunctions, OfGroupsAreOneInTheirCells) {
  for (const Index cells : cellCounts) {
    SCOPED_TRACE(cells);
    const auto [groups, indicators] = fourGroups(cells);
    expectFunctions(CellFunctions(groups, 4), indicators);
  }
}

// Chosen functions are in the requested order, and can be chosen from again.
TEST(CellFunctions, ChosenAreThoseAskedFor) {
  const MatrixXf functions = drawnFunctions(50, 6);
  const auto [groups, indicators] = fourGroups(50);
  const std::vector<Index> some{3, 0, 2}, ofThose{2, 0};
  for (const auto& [all, columns] : {std::pair(CellFunctions(functions), MatrixXd(functions.cast<double>())),
                                     std::pair(CellFunctions(groups, 4), indicators)}) {
    expectFunctions(all.chosen(some), columns(Eigen::all, some));
    MatrixXd twice(columns.rows(), 2);
    twice << columns.col(2), columns.col(3);
    expectFunctions(all.chosen(some).chosen(ofThose), twice);
    EXPECT_EQ(all.chosen({}).count(), 0);
    EXPECT_EQ(all.chosen({}).cells(), 50);
  }
}

// Scaling twice multiplies the factors, exactly for powers of two. The data shared with a copy are not
// scaled.
TEST(CellFunctions, AreScaledApartFromTheirCopies) {
  const MatrixXf functions = drawnFunctions(40, 2);
  const auto [groups, indicators] = fourGroups(40);
  for (const auto& [all, columns] : {std::pair(CellFunctions(functions), MatrixXd(functions.cast<double>())),
                                     std::pair(CellFunctions(groups, 4), indicators)}) {
    CellFunctions scaled = all;
    scaled.scale(-4);
    scaled.scale(0.125);
    expectFunctions(scaled, -0.5 * columns);
    expectFunctions(scaled.chosen({1}), -0.5 * columns.col(1));
    expectFunctions(all, columns);
  }
}

}  // namespace
}  // namespace alidade
