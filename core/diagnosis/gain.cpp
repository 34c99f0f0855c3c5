#include "core/diagnosis/gain.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

double logSum(double a, double b) {
  if (a < b) std::swap(a, b);
  return std::isinf(b) ? a : a + std::log1p(std::exp(b - a));
}

namespace {

/// Over the widths of the component, from the eigenvalues λ of its visible Gram matrix and the components c
/// of its right side: ln ∫ = Σ −½ ln(1 + w²λ/v) + ½ (w c/v)²/(1 + w²λ/v).
Gain gainOver(const std::vector<Width>& widths, const VectorXd& lambda, const VectorXd& c, double variance) {
  Gain gain;
  double best = impossible;
  for (const Width& width : widths) {
    double log = width.logChance;
    const double w2 = width.sigma * width.sigma / variance;
    for (Index i = 0; i < lambda.size(); ++i) {
      const double grown = 1 + w2 * std::max(lambda[i], 0.0);
      log += -0.5 * std::log(grown) + 0.5 * w2 * c[i] * c[i] / variance / grown;
    }
    gain.log = logSum(gain.log, log);
    if (log > best) {
      best = log;
      gain.width = width.sigma;
    }
  }
  return gain;
}

}  // namespace

Gain gainOf(const std::vector<Width>& widths, const MatrixXd& gram, const VectorXd& right, double variance) {
  if (gram.rows() == 1) return gainOver(widths, gram.col(0), right, variance);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  return gainOver(widths, eigen.eigenvalues(), eigen.eigenvectors().transpose() * right, variance);
}

Gain gainOf(const std::vector<Width>& widths, double gram, double right, double variance) {
  return gainOver(widths, VectorXd::Constant(1, gram), VectorXd::Constant(1, right), variance);
}

BentFit fitBent(const std::vector<Width>& widths, const MatrixXd& gram, const VectorXd& right,
                double variance) {
  constexpr double reach = 9, step = 0.4, narrow = 0.5;
  const auto log = [&](double x, double y) {
    VectorXd z(5);
    z << x, y, x * x / 2, x * y, y * y / 2;
    return (right.dot(z) - 0.5 * z.dot(gram * z)) / variance;
  };
  std::vector<Width> linear, bent;
  for (const Width& width : widths) (width.sigma < narrow ? linear : bent).push_back(width);
  BentFit fit{gainOf(linear, gram.topLeftCorner(2, 2), right.head(2), variance), VectorXd::Zero(2)};
  double best = fit.gain.log;
  std::vector<double> sums(bent.size(), impossible);
  for (double x = -reach; x <= reach; x += step)
    for (double y = -reach; y <= reach; y += step) {
      const double value = log(x, y), squared = x * x + y * y;
      for (std::size_t w = 0; w < bent.size(); ++w) {
        const double variance2 = bent[w].sigma * bent[w].sigma;
        const double density = value - squared / (2 * variance2) - std::log(2 * M_PI * variance2);
        sums[w] = logSum(sums[w], density + 2 * std::log(step) + bent[w].logChance);
        if (density > best) {
          best = density;
          fit.gain.width = bent[w].sigma;
          fit.weights << x, y;
        }
      }
    }
  for (const double sum : sums) fit.gain.log = logSum(fit.gain.log, sum);
  for (double size = step / 2; size > 1e-4; size /= 2) {
    const VectorXd centre = fit.weights;
    double highest = impossible;
    for (const double dx : {-size, 0.0, size})
      for (const double dy : {-size, 0.0, size}) {
        const VectorXd at = centre + Eigen::Vector2d(dx, dy);
        const double value = log(at[0], at[1]) - at.squaredNorm() / (2 * fit.gain.width * fit.gain.width);
        if (value > highest) {
          highest = value;
          fit.weights = at;
        }
      }
  }
  return fit;
}

}  // namespace alidade
