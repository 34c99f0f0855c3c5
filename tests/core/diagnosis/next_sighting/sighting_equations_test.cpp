#include "core/diagnosis/next_sighting/sighting_equations.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Normal equations of rows after their arc angle, without prior knowledge, is eliminated (Schur complement).
MatrixXd eliminated(const MatrixXd& rows, const VectorXd& along) {
  const VectorXd mixed = rows.transpose() * along;
  return rows.transpose() * rows - mixed * mixed.transpose() / along.squaredNorm();
}

TEST(SightingEquations, OfAVisitAreThoseThatItsArcAngleLeaves) {
  const MatrixXd rows = MatrixXd::Random(4, 3);
  const VectorXd along = VectorXd::Random(4);
  const MatrixXd left = withoutArcAngle(rows, along);
  EXPECT_EQ(left.rows(), 3);
  EXPECT_LT((left.transpose() * left - eliminated(rows, along)).norm(), 1e-12);
}

TEST(SightingEquations, OfTheOtherFaceAddUpToThoseOfTheWholeVisit) {
  const MatrixXd rows = MatrixXd::Random(5, 3);
  const VectorXd along = VectorXd::Random(5);
  const MatrixXd taken = withoutArcAngle(rows.topRows(2), along.head(2));
  const MatrixXd further = givenTheVisit(rows.bottomRows(3), along.tail(3), rows.topRows(2), along.head(2));
  EXPECT_LT((taken.transpose() * taken + further.transpose() * further - eliminated(rows, along)).norm(),
            1e-12);
}

}  // namespace
}  // namespace alidade
