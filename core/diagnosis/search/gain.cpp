#include "core/diagnosis/search/gain.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

double logSum(double a, double b) {
  if (a < b) std::swap(a, b);
  return std::isinf(b) ? a : a + std::log1p(std::exp(b - a));
}

double oddsOf(double difference) {
  constexpr double most = 1e6;
  return std::isnan(difference) ? 0 : std::min(std::exp(difference), most);
}

namespace {

/// One number for each of the widths, which the compiler works on side by side.
template <int Widths>
using Lane = Eigen::Array<double, Widths, 1>;

/// What was taken off before is a few columns: sums over what a component shares with them, row by row of a
/// symmetric matrix, and its Cholesky factor. `Taken`: how many where it is known beforehand, which the
/// compiler unrolls; a pattern alone may be some eighty.
template <int Taken, int Widths>
class SharedPart {
 public:
  explicit SharedPart(Index taken) : m_count(static_cast<std::size_t>(taken)) {
    if constexpr (Taken == Eigen::Dynamic) {
      m_own.resize(m_count);
      m_along.resize(m_count);
      m_matrix.resize(m_count * (m_count + 1) / 2);
    }
    for (std::size_t a = 0; a < count(); ++a) {
      m_own[a].setZero();
      m_along[a].setZero();
      for (std::size_t b = 0; b <= a; ++b) at(a, b).setConstant(a == b ? 1 : 0);
    }
  }

  /// The next column, less `step` times the one before.
  template <typename Shared>
  void add(const Shared& shared, const Lane<Widths>& step, const Lane<Widths>& inverse,
           const Lane<Widths>& scaled) {
    for (std::size_t a = 0; a < count(); ++a) {
      m_own[a] = shared[static_cast<Index>(a)] - step * m_own[a];
      m_along[a] += m_own[a] * scaled;
      for (std::size_t b = 0; b <= a; ++b) at(a, b) -= inverse * m_own[a] * m_own[b];
    }
  }

  /// Determinant of the matrix, and the sums' quadratic form with its inverse.
  std::pair<Lane<Widths>, Lane<Widths>> solve() {
    Lane<Widths> determinant = Lane<Widths>::Ones(), quadratic = Lane<Widths>::Zero();
    for (std::size_t a = 0; a < count(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        for (std::size_t c = 0; c < b; ++c) at(a, b) -= at(a, c) * at(b, c);
        if (b < a) at(a, b) /= at(b, b);
      }
      determinant *= at(a, a);
      at(a, a) = at(a, a).sqrt();
      for (std::size_t b = 0; b < a; ++b) m_along[a] -= at(a, b) * m_along[b];
      m_along[a] /= at(a, a);
      quadratic += m_along[a].square();
    }
    return {determinant, quadratic};
  }

 private:
  static constexpr std::size_t fixed = Taken == Eigen::Dynamic ? 0 : Taken;
  template <std::size_t size>
  using Lanes =
      std::conditional_t<Taken == Eigen::Dynamic, std::vector<Lane<Widths>>, std::array<Lane<Widths>, size>>;
  std::size_t m_count;
  Lanes<fixed> m_own, m_along;
  Lanes<fixed*(fixed + 1) / 2> m_matrix;

  std::size_t count() const { return Taken == Eigen::Dynamic ? m_count : fixed; }
  Lane<Widths>& at(std::size_t a, std::size_t b) { return m_matrix[a * (a + 1) / 2 + b]; }
};

/// Nothing was taken off.
template <int Widths>
class SharedPart<0, Widths> {
 public:
  explicit SharedPart(Index) {}
  template <typename Shared>
  void add(const Shared&, const Lane<Widths>&, const Lane<Widths>&, const Lane<Widths>&) {}
  std::pair<Lane<Widths>, Lane<Widths>> solve() { return {Lane<Widths>::Ones(), Lane<Widths>::Zero()}; }
};

/// The sum over the widths of e^exponent/√determinant, counted from the largest exponent, with
/// |1 + w² G/v| and cᵀ (v/w² + G)⁻¹ c by elimination from the first column to the last.
template <int Taken, int Widths>
Gain gainWith(const std::vector<Width>& widths, const TurnedColumns& columns, double variance) {
  using Lane = Lane<Widths>;
  Lane sigmas = Lane::Constant(widths.front().sigma), exponents = Lane::Constant(impossible);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    sigmas[static_cast<Index>(i)] = widths[i].sigma;
    exponents[static_cast<Index>(i)] = widths[i].logChance;
  }
  const Lane w2 = sigmas.square() / variance, narrow = w2.inverse();
  const Index count = columns.diagonal.size();
  Lane determinant = Lane::Ones(), quadratic = Lane::Zero(), step = Lane::Zero(), right = Lane::Zero();
  double beside = 0;  // of the column before
  SharedPart<Taken, Widths> part(columns.shared.cols());
  for (Index i = 0; i < count; ++i) {
    const Lane pivot = narrow + columns.diagonal[i] - beside * step;
    const Lane inverse = pivot.inverse();
    determinant *= w2 * pivot;
    if (determinant.maxCoeff() > 1e200) {
      exponents -= determinant.log() / 2;
      determinant.setOnes();
    }
    right = columns.right[i] - step * right;
    const Lane scaled = inverse * right;
    quadratic += scaled * right;
    part.add(columns.shared.row(i), step, inverse, scaled);
    beside = i + 1 < count ? columns.subdiagonal[i] : 0;
    step = beside * inverse;
  }
  const auto [determinantOfShared, along] = part.solve();
  exponents += (quadratic + along) / (2 * variance);
  const double highest = exponents.maxCoeff();
  const Lane values = (exponents - highest).exp() * (determinant * determinantOfShared).rsqrt();
  Index best = 0;
  values.maxCoeff(&best);
  return {highest + std::log(values.sum()), sigmas[best]};
}

template <int Taken>
Gain gainWith(const std::vector<Width>& widths, const TurnedColumns& columns, double variance) {
  constexpr std::size_t most = 8;
  assert(!widths.empty() && widths.size() <= most);
  if (widths.size() <= 2) return gainWith<Taken, 2>(widths, columns, variance);
  if (widths.size() <= 4) return gainWith<Taken, 4>(widths, columns, variance);
  if (widths.size() <= 6) return gainWith<Taken, 6>(widths, columns, variance);
  return gainWith<Taken, most>(widths, columns, variance);
}

}  // namespace

Gain gainOf(const std::vector<Width>& widths, const TurnedColumns& columns, double variance) {
  switch (columns.shared.cols()) {
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
  const Tridiagonal turn = tridiagonalOf(gram);
  const VectorXd turned = turn.matrix.size() > 0 ? VectorXd(turn.matrix.transpose() * right) : right;
  return gainOf(widths, TurnedColumns{turn.diagonal, turn.subdiagonal, turned, MatrixXd(gram.cols(), 0)},
                variance);
}

Tridiagonal tridiagonalOf(const MatrixXd& gram) {
  if (gram.cols() <= 2) return {{}, gram.diagonal(), gram.diagonal(1)};
  const Eigen::Tridiagonalization<MatrixXd> tridiagonal(gram);
  return {tridiagonal.matrixQ(), tridiagonal.diagonal(), tridiagonal.subDiagonal()};
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

  /// The highest place for weights of this width, from a place of the grid on.
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

  /// By Newton's steps, as long as they lead up; whether to a place where the slope is none.
  bool climb(Vector2d& at, double width) const {
    constexpr int mostSteps = 8;
    constexpr double level = 1e-9;  // of the logarithm that is still to gain
    double height = valueAt(at, width);
    for (int i = 0; i < mostSteps; ++i) {
      const Eigen::Matrix2d curvature = curvatureAt(at, width);
      if (curvature.determinant() <= 0 || curvature.trace() <= 0) return false;
      const Vector2d slope = slopeAt(at, width), move = curvature.inverse() * slope;
      if (slope.dot(move) < level) return true;
      const Vector2d next = at + move;
      const double reached = valueAt(next, width);
      if (reached <= height) return false;
      height = reached;
      at = next;
    }
    return false;
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
