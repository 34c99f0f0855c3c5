#include "core/diagnosis/evidence/bent_fit.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace alidade {

using Eigen::Index, Eigen::Vector2d;

Eigen::Vector<double, 5> bentWeights(const Vector2d& weights) {
  const double x = weights[0], y = weights[1];
  return {x, y, x * x / 2, x * y, y * y / 2};
}

Eigen::Matrix<double, 5, 2> bentDerivatives(const Vector2d& weights) {
  const double x = weights[0], y = weights[1];
  Eigen::Matrix<double, 5, 2> derivatives;
  derivatives << 1, 0, 0, 1, x, 0, y, x, 0, y;
  return derivatives;
}

namespace {

/// A grid over the weights of a bent component, with the logarithm of the evidence.
class BentGrid {
 public:
  BentGrid(const Eigen::Matrix<double, 5, 5>& gram, const Eigen::Vector<double, 5>& right, double variance)
      : m_gram(gram / variance), m_right(right / variance) {
    const Places& y = allPlaces();
    for (int i = 0; i < places; ++i) {
      const auto [c] = quarticAt(y[i]);
      m_values.col(i) = c[0] + y * (c[1] + y * (c[2] + y * (c[3] + y * c[4])));
    }
    m_highest = m_values.maxCoeff();
    for (int i = 0; i < places; ++i) {
      if (m_values.col(i).maxCoeff() > m_highest - lost)
        m_evidence.col(i) = (m_values.col(i) - m_highest).exp();
      else
        m_evidence.col(i).setZero();
    }
  }

  /// Returns ln of the integral for a normal prior of this width. Sets `highest` to ln of the integrand's
  /// maximum and `at` to its place. A peak too narrow for the grid is approximated as normal (Laplace).
  Gain integral(double width, double& highest, Vector2d& at) const {
    const double norm = -std::log(2 * M_PI * width * width);
    const Places& all = allPlaces();
    const Places prior = all.square() / (-2 * width * width), factor = prior.exp();
    double most = impossible;
    Index x = 0, y = 0;
    for (int i = 0; i < places; ++i) {
      const double ofColumn = (m_values.col(i) + prior).maxCoeff() + prior[i];
      if (ofColumn <= most) continue;
      most = ofColumn;
      x = i;
    }
    (m_values.col(x) + prior).maxCoeff(&y);
    at = closeIn({all[x], all[y]}, width);
    const Eigen::Matrix2d curvature = curvatureAt(at, width);
    if (curvature.determinant() > 0 && curvature.trace() > 1 / (step * step)) {
      highest = valueAt(at, width) + norm;
      return {highest + std::log(2 * M_PI) - 0.5 * std::log(curvature.determinant()), width};
    }
    highest = most + norm;
    const double sum = factor.matrix().dot((m_evidence.matrix() * factor.matrix()).eval());
    return {norm + m_highest + std::log(sum) + 2 * std::log(step), width};
  }

  /// Returns the most likely weights for a prior of this width, starting from a grid point.
  Vector2d closeIn(Vector2d at, double width) const {
    if (climb(at, width)) return at;
    for (double size = step / 2; size > 1e-4; size /= 2) {
      const Vector2d centre = at;
      double highest = impossible;
      for (const double dx : {-size, 0.0, size}) {
        const Quartic along = quarticAt(centre[0] + dx);
        for (const double dy : {-size, 0.0, size}) {
          const Vector2d place = centre + Vector2d(dx, dy);
          const double value = along(place[1]) - place.squaredNorm() / (2 * width * width);
          if (value <= highest) continue;
          highest = value;
          at = place;
        }
      }
    }
    climb(at, width);
    return at;
  }

 private:
  static constexpr double reach = 9, step = 0.4;
  static constexpr double lost = 121;  // drop of ln evidence that makes a column negligible for every width
  static constexpr int places = static_cast<int>(2 * reach / step) + 1;
  using Places = Eigen::Array<double, places, 1>;
  using Grid = Eigen::Array<double, places, places>;
  Eigen::Matrix<double, 5, 5> m_gram;
  Eigen::Vector<double, 5> m_right;
  Grid m_values;    ///< ln evidence, one column for each first weight
  Grid m_evidence;  ///< evidence relative to the maximum
  double m_highest;

  static const Places& allPlaces() {
    static const Places all = Places::LinSpaced(places, -reach, -reach + (places - 1) * step);
    return all;
  }

  /// Takes Newton steps as long as the value increases. Returns whether they converged.
  bool climb(Vector2d& at, double width) const {
    constexpr int mostSteps = 8;
    constexpr double level = 1e-9;  // expected increase of the logarithm at convergence
    double height = valueAt(at, width);
    for (int i = 0; i < mostSteps; ++i) {
      const Eigen::Matrix2d curvature = curvatureAt(at, width);
      if (!(curvature.determinant() > 0 && curvature.trace() > 0)) return false;
      const Vector2d slope = slopeAt(at, width), move = curvature.inverse() * slope;
      if (slope.dot(move) < level) return true;
      const Vector2d next = at + move;
      const double reached = valueAt(next, width);
      if (!(reached > height)) return false;  // also rejects NaN
      height = reached;
      at = next;
    }
    return false;
  }

  /// Returns ln of the integrand, its gradient and its negative second derivatives.
  double valueAt(const Vector2d& at, double width) const {
    return quarticAt(at[0])(at[1]) - at.squaredNorm() / (2 * width * width);
  }
  Vector2d slopeAt(const Vector2d& at, double width) const {
    return bentDerivatives(at).transpose() * (m_right - m_gram * bentWeights(at)) - at / (width * width);
  }
  Eigen::Matrix2d curvatureAt(const Vector2d& at, double width) const {
    const auto derivatives = bentDerivatives(at);
    const Eigen::Vector<double, 5> left = m_right - m_gram * bentWeights(at);
    Eigen::Matrix2d curvature = derivatives.transpose() * m_gram * derivatives;
    curvature.diagonal().array() += 1 / (width * width);
    curvature(0, 0) -= left[2];
    curvature(0, 1) -= left[3];
    curvature(1, 0) -= left[3];
    curvature(1, 1) -= left[4];
    return curvature;
  }

  /// A polynomial of the second weight.
  struct Quartic {
    std::array<double, 5> c;
    double operator()(double y) const { return c[0] + y * (c[1] + y * (c[2] + y * (c[3] + y * c[4]))); }
  };

  /// right·z − ½ zᵀ gram z at the weights z = (x, y, ½x², xy, ½y²) = a + b y + c y².
  Quartic quarticAt(double x) const {
    const Eigen::Vector<double, 5> a{x, 0, x * x / 2, 0, 0}, b{0, 1, 0, x, 0}, c{0, 0, 0, 0, 0.5};
    const Eigen::Vector<double, 5> ga = m_gram.lazyProduct(a), gb = m_gram.lazyProduct(b),
                                   gc = m_gram.lazyProduct(c);
    return {{m_right.dot(a) - 0.5 * a.dot(ga), m_right.dot(b) - a.dot(gb),
             m_right.dot(c) - 0.5 * b.dot(gb) - a.dot(gc), -b.dot(gc), -0.5 * c.dot(gc)}};
  }
};

}  // namespace

BentFit fitBent(const std::vector<Width>& widths, const Eigen::Matrix<double, 5, 5>& gram,
                const Eigen::Vector<double, 5>& right, double variance) {
  constexpr double narrow = 0.5;
  std::vector<Width> linear, bent;
  for (const Width& width : widths) (width.sigma < narrow ? linear : bent).push_back(width);
  BentFit fit{gainOf(linear, gram.topLeftCorner(2, 2), right.head(2), variance), Vector2d::Zero()};
  const BentGrid grid(gram, right, variance);
  double best = fit.gain.log;
  for (const Width& width : bent) {
    double highest = impossible;
    Vector2d at;
    fit.gain.log = logSum(fit.gain.log, grid.integral(width.sigma, highest, at).log + width.logChance);
    if (!(highest > best)) continue;
    best = highest;
    fit.gain.width = width.sigma;
    fit.weights = at;
  }
  fit.weights = grid.closeIn(fit.weights, fit.gain.width);
  return fit;
}

}  // namespace alidade
