#include "core/diagnosis/candidates/jump_columns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/full_leftover.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using test::greatest, test::leftover;

TEST(JumpColumns, AreTheSumsOverEveryReadingFromTheMomentToItsEnd) {
  constexpr double size = 1e-4;
  // Jumps before row 60 end there, as at a new sighting of the zero.
  const std::vector<JumpMoment> moments{{1, 60}, {7, 60}, {61}, {62}, {135}};
  const JumpColumns steps(leftover(), moments, size);
  const VectorXd any = leftover().residual().head(leftover().readings());
  const Eigen::Matrix2Xd products = steps.products(any);
  const std::vector<Eigen::Matrix2d> grams = steps.visibleGrams(leftover());
  for (std::size_t m = 0; m < moments.size(); ++m) {
    MatrixXd columns(leftover().readings(), 2);
    columns << leftover().column(ErrorTerm::HorizontalJump), leftover().column(ErrorTerm::VerticalJump);
    for (Index i = 0; i < columns.rows(); ++i)
      if (const std::size_t row = leftover().reading(i).sequence;
          row < moments[m].first || row >= moments[m].end)
        columns.row(i).setZero();
    columns *= size;
    const MatrixXd visible = leftover().visible(columns), gram = visible.transpose() * visible;
    const double scale = columns.squaredNorm();
    EXPECT_LT(greatest(products.col(static_cast<Index>(m)) - columns.transpose() * any), 1e-13 * scale);
    EXPECT_LT(greatest(grams[m] - gram), 1e-12 * scale);
  }
}

}  // namespace
}  // namespace alidade
