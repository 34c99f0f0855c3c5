#include "core/diagnosis/candidates/component.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <set>

#include "core/base/random_source.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// All candidates of a session, at the fit that they belong to.
class ComponentTest : public testing::TestWithParam<const char*> {
 protected:
  Inquiry inquiry = inquire(
      *modelOf(*examine(*simulate(*protocolByName(GetParam()), drawTruth(7), 7)).measurement), {}, {});
  const Leftover& leftover = inquiry.leftover;
  RandomSource random{3, 1};

  VectorXd drawn(Index size) {
    return VectorXd::NullaryExpr(size, [&](Index) { return random.normal(); });
  }
  template <typename Check>
  void eachComponent(const Check& check) {
    for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
      const Component& component = inquiry.candidates[i];
      if (const auto reading = component.grossErrorAt(); reading && leftover.reading(*reading).isZero)
        continue;
      SCOPED_TRACE(std::to_string(i) + " " + std::string(component.id()));
      check(component);
    }
  }
};

/// Tolerance for sums in a different order, and for patterns in single precision.
void expectNear(const MatrixXd& some, const MatrixXd& other, double scale) {
  ASSERT_EQ(some.rows(), other.rows());
  ASSERT_EQ(some.cols(), other.cols());
  EXPECT_LT((some - other).cwiseAbs().maxCoeff(), 1e-9 * (1 + scale));
}

// Each kind computes inner products in its own way; they must equal those of the columns.
TEST_P(ComponentTest, HasTheInnerProductsOfItsColumns) {
  const VectorXd visible = leftover.visible(drawn(leftover.rows())), any = drawn(leftover.readings());
  const SharedProducts ofVisible(leftover, visible), ofAny(leftover, any);
  eachComponent([&](const Component& component) {
    const MatrixXd columns = component.visibleColumns(leftover), whole = component.wholeColumns(leftover);
    ASSERT_EQ(columns.cols(), component.columns());
    ASSERT_EQ(whole.rows(), leftover.readings());
    expectNear(component.gram(), columns.transpose() * columns, columns.squaredNorm());
    expectNear(component.products(ofVisible), columns.transpose() * visible, columns.norm() * visible.norm());
    expectNear(component.wholeProducts(ofAny), whole.transpose() * any, whole.norm() * any.norm());
  });
}

TEST_P(ComponentTest, LeavesItsSignature) {
  eachComponent([&](const Component& component) {
    const VectorXd weights = drawn(component.weights());
    const VectorXd signature = component.signature(leftover, weights);
    const double square = signature.squaredNorm();
    EXPECT_NEAR(component.signatureSquare(weights), square, 1e-7 * (1 + square));
    EXPECT_NEAR(component.signatureLength(weights), std::sqrt(square), 1e-7 * (1 + std::sqrt(square)));
    const MatrixXd whole = component.wholeColumns(leftover);
    expectNear(component.times(leftover, weights), whole * weights, whole.norm() * weights.norm());
    if (component.response() == Response::Bent) return;
    expectNear(signature, leftover.visible(whole * weights), signature.norm());
  });
}

// A component's terms in the model eliminate its trace: the fit leaves the part that is orthogonal to the
// columns. Tolerances: weights of 300 plausible sizes are practically free; 1 % for the model's nonlinearity.
TEST_P(ComponentTest, TakesInTheModelWhatItsColumnsTake) {
  std::set<std::string_view> done;
  eachComponent([&](const Component& component) {
    if (component.isShape() || component.response() != Response::Linear) return;
    const MatrixXd gram = component.gram();
    if (gram.cols() > 1 && std::abs(gram.determinant()) < 1e-3 * gram.squaredNorm()) return;
    if (gram.trace() < 0.01 || !done.insert(component.id()).second) return;
    GapModel model = inquiry.base;
    component.addTo(model.options, leftover, VectorXd::Zero(component.weights()), 300);
    model.refit();
    ASSERT_TRUE(model.fit->isDetermined());
    const VectorXd right = component.products(SharedProducts(leftover, leftover.residual()));
    const double taken = right.dot(gram.ldlt().solve(right));
    EXPECT_NEAR(inquiry.base.fit->chiSquare - model.fit->chiSquare, taken, 0.01 * (1 + taken));
    const std::vector<CauseParameter> parameters =
        component.grossErrorAt() ? std::vector<CauseParameter>{} : component.parameters(model);
    for (const CauseParameter& parameter : parameters) EXPECT_TRUE(std::isfinite(parameter.value));
    EXPECT_EQ(component.grossErrorAt().has_value(), parameters.empty());
  });
  EXPECT_GT(done.size(), 8u);
}

INSTANTIATE_TEST_SUITE_P(Protocols, ComponentTest, testing::Values("full", "paper"));

}  // namespace
}  // namespace alidade
