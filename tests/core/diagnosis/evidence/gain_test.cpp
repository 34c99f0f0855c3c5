#include "core/diagnosis/evidence/gain.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "core/base/random_source.h"

namespace alidade {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd drawn(RandomSource& random, Eigen::Index rows, Eigen::Index columns) {
  return MatrixXd::NullaryExpr(rows, columns, [&] { return random.normal(); });
}

/// ln of the density of N(0, covariance).
double logDensity(const VectorXd& x, const MatrixXd& covariance) {
  const Eigen::LLT<MatrixXd> factor(covariance);
  return -factor.matrixLLT().diagonal().array().log().sum() - 0.5 * factor.matrixL().solve(x).squaredNorm() -
         0.5 * static_cast<double>(x.size()) * std::log(2 * std::numbers::pi);
}

// The evidence is the density of the readings integrated over the weights: normal with covariance v + w² C
// Cᵀ. The test computes each density from the full matrix.
TEST(Gain, IsTheRatioOfTwoNormalDensities) {
  RandomSource random(1);
  constexpr double variance = 1.7;
  const std::vector<Width> widths{{0.3, std::log(0.25)}, {2, std::log(0.75)}};
  const MatrixXd columns = drawn(random, 30, 3);
  const VectorXd readings = drawn(random, 30, 1);
  const MatrixXd noise = variance * MatrixXd::Identity(30, 30);
  double evidence = 0;
  for (const Width& width : widths)
    evidence += std::exp(width.logChance + logDensity(readings, noise + width.sigma * width.sigma * columns *
                                                                            columns.transpose()));
  const Gain gain = gainOf(widths, columns.transpose() * columns, columns.transpose() * readings, variance);
  EXPECT_NEAR(gain.log, std::log(evidence) - logDensity(readings, noise), 1e-10);
}

// With other columns of width u eliminated before, the noise has the covariance v + u² B Bᵀ. Few columns use
// an unrolled loop; a pattern has many.
TEST(Gain, KnowsWhatWasTakenOffBefore) {
  RandomSource random(2);
  constexpr double variance = 0.8, before = 1.5;
  const std::vector<Width> widths{{0.5, std::log(0.5)}, {4, std::log(0.5)}};
  for (const int taken : {1, 2, 3, 4, 5, 30}) {
    SCOPED_TRACE(taken);
    MatrixXd columns = drawn(random, 60, 5);
    const MatrixXd others = drawn(random, 60, taken);
    const VectorXd readings = drawn(random, 60, 1);
    const MatrixXd noise =
        variance * MatrixXd::Identity(60, 60) + before * before * others * others.transpose();
    double evidence = 0;
    for (const Width& width : widths)
      evidence +=
          std::exp(width.logChance +
                   logDensity(readings, noise + width.sigma * width.sigma * columns * columns.transpose()) -
                   logDensity(readings, noise));
    // v noise⁻¹ = 1 − V Vᵀ
    MatrixXd gram = others.transpose() * others;
    gram.diagonal().array() += variance / (before * before);
    const MatrixXd off = Eigen::LLT<MatrixXd>(gram).matrixL().solve(others.transpose()).transpose();
    const Tridiagonal turn = tridiagonalOf(columns.transpose() * columns);
    columns *= turn.matrix;
    const VectorXd right = columns.transpose() * (readings - off * (off.transpose() * readings));
    const MatrixXd shared = columns.transpose() * off;
    const Gain gain = gainOf(widths, TurnedColumns{turn.diagonal, turn.subdiagonal, right, shared}, variance);
    EXPECT_NEAR(gain.log, std::log(evidence), 1e-10);
  }
}

}  // namespace
}  // namespace alidade
