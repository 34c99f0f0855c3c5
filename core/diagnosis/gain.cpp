#include "core/diagnosis/gain.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

double logSum(double a, double b) {
  if (a < b) std::swap(a, b);
  return std::isinf(b) ? a : a + std::log1p(std::exp(b - a));
}

namespace {

/// What was taken off before is a few columns; on the stack up to here.
constexpr int mostTaken = 16;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostTaken, mostTaken>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostTaken, 1>;

/// Determinant and quadratic form of v/w² + squares − sharedᵀ shared.
double logGainAt(double w2, const TurnedColumns& columns, double variance) {
  const Index count = columns.squares.size(), taken = columns.shared.rows();
  double grown = 1, logGrown = 0, quadratic = 0;
  SmallMatrix inner = SmallMatrix::Identity(taken, taken);
  SmallVector along = SmallVector::Zero(taken);
  for (Index i = 0; i < count; ++i) {
    const double square = std::max(columns.squares[i], 0.0), inverse = 1 / (1 / w2 + square);
    grown *= 1 + w2 * square;
    if (grown > 1e200) {
      logGrown += std::log(grown);
      grown = 1;
    }
    const double scaled = inverse * columns.right[i];
    quadratic += scaled * columns.right[i];
    for (Index a = 0; a < taken; ++a) {
      const double share = columns.shared(a, i);
      along[a] += share * scaled;
      for (Index b = 0; b <= a; ++b) inner(a, b) -= inverse * share * columns.shared(b, i);
    }
  }
  if (taken > 0) {
    const Eigen::LLT<SmallMatrix> factor(inner);
    grown *= factor.matrixLLT().diagonal().prod() * factor.matrixLLT().diagonal().prod();
    quadratic += factor.matrixL().solve(along).squaredNorm();
  }
  return -0.5 * (logGrown + std::log(grown)) + 0.5 * quadratic / variance;
}

}  // namespace

Gain gainOf(const std::vector<Width>& widths, const TurnedColumns& columns, double variance) {
  Gain gain;
  double best = impossible;
  for (const Width& width : widths) {
    const double log = width.logChance + logGainAt(width.sigma * width.sigma / variance, columns, variance);
    gain.log = logSum(gain.log, log);
    if (log > best) {
      best = log;
      gain.width = width.sigma;
    }
  }
  return gain;
}

Gain gainOf(const std::vector<Width>& widths, const MatrixXd& gram, const VectorXd& right, double variance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  const VectorXd turned = eigen.eigenvectors().transpose() * right;
  return gainOf(widths, TurnedColumns{eigen.eigenvalues(), turned, MatrixXd(0, gram.cols())}, variance);
}

namespace {

/// The weights of a bending component on a grid, with the logarithm of the evidence there.
class BentGrid {
 public:
  BentGrid(const Eigen::Matrix<double, 5, 5>& gram, const Eigen::Vector<double, 5>& right, double variance)
      : m_gram(gram / variance), m_right(right / variance) {}

  double logEvidence(double x, double y) const {
    const Eigen::Vector<double, 5> z{x, y, x * x / 2, x * y, y * y / 2};
    return (m_right - 0.5 * m_gram.lazyProduct(z)).dot(z);
  }

  /// ln of the integral with weights normal of this width; `highest` and `at`: of the integrand.
  double integral(double width, double& highest, Vector2d& at) {
    if (m_values.empty()) fill();
    const double perSquare = -1 / (2 * width * width), norm = -std::log(2 * M_PI * width * width);
    std::vector<double> logs(m_values.size());
    std::size_t best = 0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      logs[i] = m_values[i] + perSquare * m_squares[i];
      if (logs[i] > logs[best]) best = i;
    }
    double sum = 0;
    constexpr double lost = 40;  // e⁻⁴⁰ is rounding
    for (const double log : logs)
      if (log > logs[best] - lost) sum += std::exp(log - logs[best]);
    highest = logs[best] + norm;
    at = m_places[best];
    return highest + std::log(sum) + 2 * std::log(step);
  }

  /// The highest place for weights of this width, from a place of the grid on.
  Vector2d closeIn(Vector2d at, double width) const {
    for (double size = step / 2; size > 1e-4; size /= 2) {
      const Vector2d centre = at;
      double highest = impossible;
      for (const double dx : {-size, 0.0, size})
        for (const double dy : {-size, 0.0, size}) {
          const Vector2d place = centre + Vector2d(dx, dy);
          const double value = logEvidence(place[0], place[1]) - place.squaredNorm() / (2 * width * width);
          if (value <= highest) continue;
          highest = value;
          at = place;
        }
    }
    return at;
  }

 private:
  static constexpr double reach = 9, step = 0.4;
  Eigen::Matrix<double, 5, 5> m_gram;
  Eigen::Vector<double, 5> m_right;
  std::vector<Vector2d> m_places;
  std::vector<double> m_squares, m_values;

  void fill() {
    for (double x = -reach; x <= reach; x += step)
      for (double y = -reach; y <= reach; y += step) {
        m_places.emplace_back(x, y);
        m_squares.push_back(x * x + y * y);
        m_values.push_back(logEvidence(x, y));
      }
  }
};

}  // namespace

BentFit fitBent(const std::vector<Width>& widths, const Eigen::Matrix<double, 5, 5>& gram,
                const Eigen::Vector<double, 5>& right, double variance) {
  constexpr double narrow = 0.5;
  std::vector<Width> linear, bent;
  for (const Width& width : widths) (width.sigma < narrow ? linear : bent).push_back(width);
  BentFit fit{gainOf(linear, gram.topLeftCorner(2, 2), right.head(2), variance), Vector2d::Zero()};
  BentGrid grid(gram, right, variance);
  double best = fit.gain.log;
  for (const Width& width : bent) {
    double highest = impossible;
    Vector2d at;
    fit.gain.log = logSum(fit.gain.log, grid.integral(width.sigma, highest, at) + width.logChance);
    if (highest <= best) continue;
    best = highest;
    fit.gain.width = width.sigma;
    fit.weights = at;
  }
  fit.weights = grid.closeIn(fit.weights, fit.gain.width);
  return fit;
}

}  // namespace alidade
