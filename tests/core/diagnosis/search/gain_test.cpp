#include "core/diagnosis/search/gain.h"

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

// The evidence is the density of the readings with the weights integrated out: normal, of covariance
// v + w² C Cᵀ. Worked out from that matrix whole, one density after the other.
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

// With other columns, of width u, taken off before, the noise has the covariance v + u² B Bᵀ. A few are
// worked on unrolled; a pattern takes many.
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

// Where nothing bends, the integral over the grid is the closed form. The grid ends at three times the
// greatest width and its step is a quarter of what the readings tell here: 1e-4 is what it lacks.
TEST(Gain, OfABentComponentThatDoesNotBendIsTheClosedForm) {
  Eigen::Matrix<double, 5, 5> gram = Eigen::Matrix<double, 5, 5>::Zero();
  gram.topLeftCorner(2, 2) << 0.5, 0.1, 0.1, 0.4;
  Eigen::Vector<double, 5> right = Eigen::Vector<double, 5>::Zero();
  right.head(2) << 0.7, -0.4;
  const std::vector<Width> widths{{0.3, std::log(0.5)}, {1, std::log(0.5)}};
  const BentFit bent = fitBent(widths, gram, right, 1);
  const Gain closed = gainOf(widths, gram.topLeftCorner(2, 2), right.head(2), 1);
  EXPECT_NEAR(bent.gain.log, closed.log, 1e-4);
}

// Readings that tell the weights to a hundredth: the peak lies between the places of the grid. Against sums
// of the density itself at steps of a tenth of the peak; Laplace's method lacks what the peak bends within
// itself.
TEST(Gain, OfANarrowPeakIsTheIntegralOverIt) {
  Eigen::Matrix<double, 7, 5> columns;
  columns << 60, 10, 2, 1, 0,  //
      -20, 50, 1, -2, 1,       //
      30, 30, -1, 0, 2,        //
      5, -45, 0, 2, -1,        //
      -40, 5, 1, 1, 1,         //
      15, 25, -2, 1, 0,        //
      10, -20, 1, 0, -2;
  const Eigen::Vector2d truth(1.33, -0.71);
  Eigen::Vector<double, 7> readings = columns * bentWeights(truth);
  readings += (Eigen::Vector<double, 7>() << 0.5, -1.1, 0.3, 0.8, -0.2, -0.6, 0.9).finished();
  const Eigen::Matrix<double, 5, 5> gram = columns.transpose() * columns;
  const Eigen::Vector<double, 5> right = columns.transpose() * readings;
  const auto logDensityAt = [&](const Eigen::Vector2d& at) {
    const Eigen::Vector<double, 5> z = bentWeights(at);
    return right.dot(z) - 0.5 * z.dot(gram * z) - at.squaredNorm() / 2 - std::log(2 * M_PI);
  };
  const double top = logDensityAt(truth), step = 1e-3;
  double sum = 0;
  for (int i = -150; i <= 150; ++i)
    for (int j = -150; j <= 150; ++j)
      sum += std::exp(logDensityAt(truth + step * Eigen::Vector2d(i, j)) - top) * step * step;
  constexpr double never = -1e6;  // ln of the chance of the width that knows no bending
  const BentFit bent = fitBent({{0.3, never}, {1, 0}}, gram, right, 1);
  EXPECT_NEAR(bent.gain.log, top + std::log(sum), 0.01);
}

}  // namespace
}  // namespace alidade
