#include "core/diagnosis/gain.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

double logSum(double a, double b) {
  if (a < b) std::swap(a, b);
  return std::isinf(b) ? a : a + std::log1p(std::exp(b - a));
}

namespace {

/// What was taken off before is a few columns: sums over what a component shares with them, row by row of a
/// symmetric matrix, and its Cholesky factor. `Taken`: how many where it is known beforehand, which the
/// compiler unrolls.
template <int Taken>
class SharedPart {
 public:
  explicit SharedPart(Index taken) : m_count(taken) {
    m_matrix.setIdentity(taken, taken);
    m_along.setZero(taken);
  }

  void add(const double* shared, double inverse, double scaled) {
    for (Index a = 0; a < taken(); ++a) {
      m_along[a] += shared[a] * scaled;
      for (Index b = 0; b <= a; ++b) m_matrix(a, b) -= inverse * shared[a] * shared[b];
    }
  }

  /// Determinant of the matrix, and the sums' quadratic form with its inverse.
  std::pair<double, double> solve() {
    double determinant = 1, quadratic = 0;
    for (Index a = 0; a < taken(); ++a) {
      for (Index b = 0; b <= a; ++b) {
        for (Index c = 0; c < b; ++c) m_matrix(a, b) -= m_matrix(a, c) * m_matrix(b, c);
        if (b < a) m_matrix(a, b) /= m_matrix(b, b);
      }
      determinant *= m_matrix(a, a);
      m_matrix(a, a) = std::sqrt(m_matrix(a, a));
      for (Index b = 0; b < a; ++b) m_along[a] -= m_matrix(a, b) * m_along[b];
      m_along[a] /= m_matrix(a, a);
      quadratic += m_along[a] * m_along[a];
    }
    return {determinant, quadratic};
  }

 private:
  static constexpr int most =
      Taken == Eigen::Dynamic ? 16 : Taken;  // six misreadings, or twice three columns
  Index taken() const { return Taken == Eigen::Dynamic ? m_count : Taken; }
  Index m_count;
  Eigen::Matrix<double, Taken, Taken, Eigen::ColMajor, most, most> m_matrix;
  Eigen::Matrix<double, Taken, 1, Eigen::ColMajor, most, 1> m_along;
};

/// |1 + w² G/v| and cᵀ (v/w² + G)⁻¹ c at one width; a part of the determinant's logarithm where it is large.
struct AtWidth {
  double determinant = 1, logMore = 0, quadratic = 0;
};

template <int Taken>
AtWidth atWidth(double w2, const TurnedColumns& columns) {
  const Index count = columns.squares.size(), stride = columns.shared.outerStride();
  const double *squares = columns.squares.data(), *right = columns.right.data(),
               *shared = columns.shared.data(), narrow = 1 / w2;
  AtWidth at;
  SharedPart<Taken> part(columns.shared.rows());
  for (Index i = 0; i < count; ++i) {
    const double square = std::max(squares[i], 0.0), inverse = 1 / (narrow + square);
    at.determinant *= 1 + w2 * square;
    if (at.determinant > 1e200) {
      at.logMore += std::log(at.determinant);
      at.determinant = 1;
    }
    const double scaled = inverse * right[i];
    at.quadratic += scaled * right[i];
    part.add(shared + i * stride, inverse, scaled);
  }
  const auto [determinant, along] = part.solve();
  at.determinant *= determinant;
  at.quadratic += along;
  return at;
}

template <>
AtWidth atWidth<0>(double w2, const TurnedColumns& columns) {
  AtWidth at;
  for (Index i = 0; i < columns.squares.size(); ++i) {
    const double square = std::max(columns.squares[i], 0.0);
    at.determinant *= 1 + w2 * square;
    if (at.determinant > 1e200) {
      at.logMore += std::log(at.determinant);
      at.determinant = 1;
    }
    at.quadratic += columns.right[i] * columns.right[i] / (1 / w2 + square);
  }
  return at;
}

/// The sum over the widths of e^exponent/√determinant, counted from the largest exponent.
template <int Taken>
Gain gainWith(const std::vector<Width>& widths, const TurnedColumns& columns, double variance) {
  constexpr std::size_t most = 8;
  assert(!widths.empty() && widths.size() <= most);
  std::array<double, most> exponents, factors;
  double highest = impossible;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const AtWidth at = atWidth<Taken>(widths[i].sigma * widths[i].sigma / variance, columns);
    exponents[i] = widths[i].logChance + at.quadratic / (2 * variance) - at.logMore / 2;
    factors[i] = 1 / std::sqrt(at.determinant);
    highest = std::max(highest, exponents[i]);
  }
  Gain gain;
  double sum = 0, best = -1;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double value = factors[i] * (exponents[i] == highest ? 1 : std::exp(exponents[i] - highest));
    sum += value;
    if (value > best) {
      best = value;
      gain.width = widths[i].sigma;
    }
  }
  gain.log = highest + std::log(sum);
  return gain;
}

}  // namespace

Gain gainOf(const std::vector<Width>& widths, const TurnedColumns& columns, double variance) {
  switch (columns.shared.rows()) {
    case 0:
      return gainWith<0>(widths, columns, variance);
    case 1:
      return gainWith<1>(widths, columns, variance);
    case 2:
      return gainWith<2>(widths, columns, variance);
    case 3:
      return gainWith<3>(widths, columns, variance);
    case 4:
      return gainWith<4>(widths, columns, variance);
    default:
      return gainWith<Eigen::Dynamic>(widths, columns, variance);
  }
}

Gain gainOf(const std::vector<Width>& widths, const MatrixXd& gram, const VectorXd& right, double variance) {
  if (gram.cols() == 1) return gainOf(widths, TurnedColumns{gram.col(0), right, MatrixXd(0, 1)}, variance);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  const VectorXd turned = eigen.eigenvectors().transpose() * right;
  return gainOf(widths, TurnedColumns{eigen.eigenvalues(), turned, MatrixXd(0, gram.cols())}, variance);
}

namespace {

/// The weights of a bending component on a grid, with the logarithm of the evidence there.
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

  /// ln of the integral with weights normal of this width; `highest` and `at`: of the integrand. A peak too
  /// narrow for the grid is taken as normal (Laplace).
  double integral(double width, double& highest, Vector2d& at) const {
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
      return highest + std::log(2 * M_PI) - 0.5 * std::log(curvature.determinant());
    }
    highest = most + norm;
    const double sum = factor.matrix().dot((m_evidence.matrix() * factor.matrix()).eval());
    return norm + m_highest + std::log(sum) + 2 * std::log(step);
  }

  /// The highest place for weights of this width, from a place of the grid on.
  Vector2d closeIn(Vector2d at, double width) const {
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
    for (int i = 0; i < 5; ++i) {
      const Eigen::Matrix2d curvature = curvatureAt(at, width);
      if (curvature.determinant() <= 0 || curvature.trace() <= 0) break;
      const Vector2d next = at + curvature.inverse() * slopeAt(at, width);
      if (valueAt(next, width) <= valueAt(at, width)) break;
      at = next;
    }
    return at;
  }

 private:
  static constexpr double reach = 9, step = 0.4;
  static constexpr double lost = 121;  // e⁻⁴⁰ of the highest, however much of that the narrowest prior takes
  static constexpr int places = static_cast<int>(2 * reach / step) + 1;
  using Places = Eigen::Array<double, places, 1>;
  using Grid = Eigen::Array<double, places, places>;
  Eigen::Matrix<double, 5, 5> m_gram;
  Eigen::Vector<double, 5> m_right;
  Grid m_values;    ///< of the logarithm, a column for each first weight
  Grid m_evidence;  ///< counted from the highest
  double m_highest;

  static const Places& allPlaces() {
    static const Places all = Places::LinSpaced(places, -reach, -reach + (places - 1) * step);
    return all;
  }

  /// ln of the integrand, its slope and its second derivatives with their sign turned.
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
