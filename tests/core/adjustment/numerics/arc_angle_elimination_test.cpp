#include "core/adjustment/numerics/arc_angle_elimination.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace alidade {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Arbitrary numbers, the same each time.
MatrixXd numbers(Eigen::Index rows, Eigen::Index columns, double seed) {
  return MatrixXd::NullaryExpr(rows, columns, [seed](Eigen::Index i, Eigen::Index j) {
    return std::sin(seed + 1.7 * static_cast<double>(i) + 2.9 * static_cast<double>(j));
  });
}

/// ∂(readings)/∂φ of one visit, not of unit length.
VectorXd slopes(Eigen::Index readings) {
  return 3 * numbers(readings, 1, 0.4).col(0).array() + 0.2;
}

// The unknowns of the whole system, including φ, equal those of the system without φ.
TEST(ArcAngleElimination, LeavesTheSolutionOfTheWholeSystem) {
  for (const Eigen::Index readings : {4, 5}) {
    const MatrixXd jacobian = numbers(readings, 2, 0);
    const VectorXd residual = numbers(readings, 1, 5), slope = slopes(readings);
    MatrixXd whole(readings, 3);
    whole << jacobian, slope;
    const VectorXd expected = (whole.transpose() * whole).ldlt().solve(whole.transpose() * residual).head(2);

    RowMajorMatrix rows(readings, 3);
    rows << jacobian, residual;
    VectorXd share;
    eliminateArcAngle(rows, VectorXd(slope.normalized()), share);
    const MatrixXd left = rows.leftCols(2);
    const VectorXd found = (left.transpose() * left).ldlt().solve(left.transpose() * rows.col(2));
    EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
  }
}

TEST(ArcAngleElimination, MakesTheSchurComplementOfTheNormalEquations) {
  const MatrixXd jacobian = numbers(4, 3, 1);
  const VectorXd slope = slopes(4), mixed = jacobian.transpose() * slope;
  const MatrixXd complement =
      jacobian.transpose() * jacobian - mixed * mixed.transpose() / slope.squaredNorm();
  RowMajorMatrix rows = jacobian;
  VectorXd share;
  eliminateArcAngle(rows, VectorXd(slope.normalized()), share);
  EXPECT_LT((rows.transpose() * rows - complement).norm(), 1e-14);
  EXPECT_LT((rows.transpose() * slope).norm(), 1e-14);
}

// Visits of one to five readings, one of which is excluded, and one visit with all readings excluded.
TEST(ArcAngleElimination, OfAColumnIsThatOfEachVisit) {
  const std::vector<std::ptrdiff_t> ends{2, 3, 7, 12, 12, 14};
  VectorXd along = slopes(14), column = numbers(14, 1, 3);
  along[4] = along[12] = along[13] = 0;
  std::ptrdiff_t first = 0;
  VectorXd expected = column;
  for (const std::ptrdiff_t end : ends) {
    auto u = along.segment(first, end - first);
    u.normalize();
    const MatrixXd projector = MatrixXd::Identity(end - first, end - first) - u * u.transpose();
    expected.segment(first, end - first) = projector * column.segment(first, end - first);
    first = end;
  }
  eliminateArcAngles({column.data(), 14}, {along.data(), 14}, ends);
  EXPECT_LT((column - expected).norm(), 1e-14);
  EXPECT_EQ(column[13], expected[13]);
}

}  // namespace
}  // namespace alidade
