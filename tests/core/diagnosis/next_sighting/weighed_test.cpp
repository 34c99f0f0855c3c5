#include "core/diagnosis/next_sighting/weighed.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/random_source.h"
#include "core/diagnosis/evidence/bent_fit.h"
#include "core/diagnosis/result/noise_policy.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd drawn(RandomSource& random, Index rows, Index columns) {
  MatrixXd matrix(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) matrix(i, j) = random.normal();
  return matrix;
}

/// Two unknowns, a cause with two weights and a cause with one weight; each cause has one prior width.
struct Case {
  std::vector<Width> one = evenly({0.7}), other = evenly({2});
  SightingEquations equations;

  explicit Case(std::uint64_t seed) {
    RandomSource random(seed);
    equations.taken = {drawn(random, 9, 2), drawn(random, 9, 3)};
    equations.possible = {{drawn(random, 2, 2), drawn(random, 2, 3)}};
    equations.priorWeights = Eigen::Vector2d(0.2, 0.5);
    equations.priorResiduals = VectorXd::Zero(2);
    equations.hypotheses = {{"one", 0, 2, &one, 0.3}, {"other", 2, 1, &other, 0.1}};
    equations.priorOdds = 0.4 + noise_policy::odds;
    // Readings without a cause: the unknowns follow their prior, the rest is noise.
    equations.residual = drawn(random, 9, 1) +
                         equations.taken.unknowns * Eigen::Vector2d(5 * random.normal(), 2 * random.normal());
  }

  MatrixXd covariance(const MatrixXd& unknowns) const {
    MatrixXd sum =
        unknowns * equations.priorWeights.cwiseAbs2().cwiseInverse().asDiagonal() * unknowns.transpose();
    sum.diagonal().array() += 1;
    return sum;
  }
};

double logDensity(const VectorXd& y, const MatrixXd& covariance) {
  return -0.5 * (y.dot(covariance.llt().solve(y)) + std::log(covariance.determinant()));
}

const Weighed& of(const WeighedCauses& causes, std::string_view id) {
  return *std::ranges::find(causes.all(), id, &Weighed::cause);
}

TEST(WeighedCauses, HaveTheOddsOfTheDenseNormalDensities) {
  const Case toy(4);
  const WeighedCauses causes(toy.equations);
  const VectorXd& y = toy.equations.residual;
  const MatrixXd nothing = toy.covariance(toy.equations.taken.unknowns);
  const MatrixXd& columns = toy.equations.taken.causes;
  const MatrixXd one = nothing + 0.49 * columns.leftCols(2) * columns.leftCols(2).transpose();
  const MatrixXd other = nothing + 4 * columns.col(2) * columns.col(2).transpose();
  const double none = of(causes, "").probability;
  EXPECT_NEAR(of(causes, "one").probability / none,
              0.3 * std::exp(logDensity(y, one) - logDensity(y, nothing)), 1e-9);
  EXPECT_NEAR(of(causes, "other").probability / none,
              0.1 * std::exp(logDensity(y, other) - logDensity(y, nothing)), 1e-9);
}

/// The simulated cause, of 4 and −3 plausible sizes, has a prior about its estimate that is as wide as the
/// cause is large.
TEST(WeighedCauses, WithACauseHaveTheOddsOfTheDenseNormalDensities) {
  Case toy(6);
  const MatrixXd& columns = toy.equations.taken.causes;
  toy.equations.residual += columns.leftCols(2) * Eigen::Vector2d(4, -3);
  toy.one = evenly({4});
  const WeighedCauses causes(toy.equations);
  const Weighed one = of(causes, "one");
  const double width = one.weights.norm();
  ASSERT_GT(width, 2);
  const SightingEquations equations = withCause(toy.equations, one, {"one"});
  const WeighedCauses extended(equations);
  const VectorXd y = toy.equations.residual - columns.leftCols(2) * one.weights;
  const MatrixXd alone = toy.covariance(toy.equations.taken.unknowns) +
                         width * width * columns.leftCols(2) * columns.leftCols(2).transpose();
  const MatrixXd both = alone + 4 * columns.col(2) * columns.col(2).transpose();
  EXPECT_NEAR(of(extended, "other").probability / of(extended, "").probability,
              0.1 * std::exp(logDensity(y, both) - logDensity(y, alone)), 1e-9);
  EXPECT_EQ(std::ranges::count(extended.all(), "one", &Weighed::cause), 0);
  EXPECT_NEAR(equations.priorOdds, 0.1 + noise_policy::odds, 1e-12);
  EXPECT_LE(extended.chiSquareAfter(of(extended, "")), causes.chiSquareAfter(one) + 1e-9);
}

TEST(WeighedCauses, WithACauseOfFixedSizeHaveNoFurtherUnknown) {
  Case toy(7);
  toy.equations.hypotheses[1].widths = nullptr;
  const Weighed fixed = of(WeighedCauses(toy.equations), "other");
  const SightingEquations extended = withCause(toy.equations, fixed, {"other"});
  EXPECT_EQ(extended.taken.unknowns.cols(), 2);
  EXPECT_LT((extended.residual - (toy.equations.residual - toy.equations.taken.causes.col(2))).norm(), 1e-12);
}

/// The unknowns of a bent cause are its two sizes: their columns are derivatives of its trace.
TEST(WeighedCauses, WithABentCauseHaveItsTwoSizesAsUnknowns) {
  Case toy(8);
  toy.other = evenly({0.3, 2});
  RandomSource random(8);
  toy.equations.taken.causes = drawn(random, 9, 5);
  toy.equations.possible[0].causes = drawn(random, 2, 5);
  toy.equations.hypotheses = {{"bent", 0, 5, &toy.other, 0.1, true}};
  const Weighed bent = of(WeighedCauses(toy.equations), "bent");
  const SightingEquations extended = withCause(toy.equations, bent, {"bent"});
  ASSERT_EQ(extended.taken.unknowns.cols(), 4);
  for (const int i : {0, 1}) {
    constexpr double step = 1e-6;
    const Eigen::Vector2d at = bent.weights.head<2>(), by = step * Eigen::Vector2d::Unit(i);
    const VectorXd change =
        toy.equations.taken.causes * (bentWeights(at + by) - bentWeights(at - by)) / (2 * step);
    EXPECT_LT((extended.taken.unknowns.col(2 + i) - change).norm(), 1e-8) << i;
  }
}

/// The conditional distribution of the next readings, from the joint covariance of all readings.
Prediction conditional(const Case& toy, const MatrixXd& weights) {
  MatrixXd unknowns(11, 2), causes(11, 3);
  unknowns << toy.equations.taken.unknowns, toy.equations.possible[0].unknowns;
  causes << toy.equations.taken.causes, toy.equations.possible[0].causes;
  const MatrixXd all = toy.covariance(unknowns) + causes * weights * causes.transpose();
  const MatrixXd gain = all.block(9, 0, 2, 9) * all.topLeftCorner(9, 9).inverse();
  return {gain * toy.equations.residual, all.block(9, 9, 2, 2) - gain * all.block(0, 9, 9, 2)};
}

TEST(WeighedCauses, PredictTheNextReadingsAsTheJointDistributionDoes) {
  const Case toy(5);
  const WeighedCauses causes(toy.equations);
  const WeighedCauses::Predictor predictor(causes, toy.equations.possible[0]);
  const Prediction nothing = conditional(toy, MatrixXd::Zero(3, 3));
  for (const auto& [id, prior] :
       {std::pair("one", Eigen::Vector3d(0.49, 0.49, 0)), std::pair("other", Eigen::Vector3d(0, 0, 4))}) {
    const Prediction expected = conditional(toy, prior.asDiagonal());
    const Prediction found = predictor.under(of(causes, id));
    EXPECT_LT((found.mean - (expected.mean - nothing.mean)).norm(), 1e-9) << id;
    EXPECT_LT((found.covariance - expected.covariance).norm(), 1e-9) << id;
  }
}

/// Without a cause, a Bayes factor has the mean 1. By Markov it exceeds 20 in at most one of 20 cases.
TEST(WeighedCauses, GiveEvidenceAgainstNothingThatIsAMartingale) {
  constexpr int count = 4000;
  int exceeds = 0;
  for (int i = 0; i < count; ++i)
    exceeds += WeighedCauses(Case(100 + static_cast<std::uint64_t>(i)).equations).logEvidence() > std::log(20)
                   ? 1
                   : 0;
  EXPECT_LE(exceeds, count / 20);
}

}  // namespace
}  // namespace alidade
