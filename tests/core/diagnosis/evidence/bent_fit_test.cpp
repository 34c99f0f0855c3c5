#include "core/diagnosis/evidence/bent_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace alidade {
namespace {

// Without second-order terms the integral over the grid has a closed form. The grid ends at three times the
// largest width, and its step is a quarter of the posterior σ, so its error is 1e-4.
TEST(BentFit, OfWhatDoesNotBendIsTheClosedForm) {
  Eigen::Matrix<double, 5, 5> gram = Eigen::Matrix<double, 5, 5>::Zero();
  gram.topLeftCorner(2, 2) << 0.5, 0.1, 0.1, 0.4;
  Eigen::Vector<double, 5> right = Eigen::Vector<double, 5>::Zero();
  right.head(2) << 0.7, -0.4;
  const std::vector<Width> widths{{0.3, std::log(0.5)}, {1, std::log(0.5)}};
  const BentFit bent = fitBent(widths, gram, right, 1);
  const Gain closed = gainOf(widths, gram.topLeftCorner(2, 2), right.head(2), 1);
  EXPECT_NEAR(bent.gain.log, closed.log, 1e-4);
}

// Readings that determine the weights to a hundredth: the peak is narrower than the grid. The reference is a
// sum of the density at steps of a tenth of the peak. Laplace's method omits the curvature within the peak.
TEST(BentFit, OfANarrowPeakIsTheIntegralOverIt) {
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
  constexpr double never = -1e6;  // logarithm of the probability of the width without second-order terms
  const BentFit bent = fitBent({{0.3, never}, {1, 0}}, gram, right, 1);
  EXPECT_NEAR(bent.gain.log, top + std::log(sum), 0.01);
}

}  // namespace
}  // namespace alidade
