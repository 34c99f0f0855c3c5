#include "core/diagnosis/evidence/gain.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

double logSum(double a, double b) {
  if (a < b) std::swap(a, b);
  return std::isinf(b) ? a : a + std::log1p(std::exp(b - a));
}

double oddsOf(double difference) {
  constexpr double most = 1e6;
  return std::isnan(difference) ? 0 : std::min(std::exp(difference), most);
}

namespace {

/// One number for each width, in a form that the compiler vectorises.
template <int Widths>
using Lane = Eigen::Array<double, Widths, 1>;

/// Accumulates and solves the small matrix of the Woodbury identity, which has one row for each eliminated
/// column. `Taken` is the number of these columns if loops are to be unrolled, else `Eigen::Dynamic`: a
/// pattern may have about eighty columns.
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

  /// Adds the next column, a row of `shared`, minus `step` times the previous column.
  void add(const Eigen::Ref<const MatrixXd>& shared, Index row, const Lane<Widths>& step,
           const Lane<Widths>& inverse, const Lane<Widths>& scaled) {
    for (std::size_t a = 0; a < count(); ++a) {
      m_own[a] = shared(row, static_cast<Index>(a)) - step * m_own[a];
      m_along[a] += m_own[a] * scaled;
      for (std::size_t b = 0; b <= a; ++b) at(a, b) -= inverse * m_own[a] * m_own[b];
    }
  }

  /// Returns the determinant of the matrix, and the quadratic form of the vector with its inverse.
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

/// The case in which no column was eliminated before.
template <int Widths>
class SharedPart<0, Widths> {
 public:
  explicit SharedPart(Index) {}
  void add(const Eigen::Ref<const MatrixXd>&, Index, const Lane<Widths>&, const Lane<Widths>&,
           const Lane<Widths>&) {}
  std::pair<Lane<Widths>, Lane<Widths>> solve() { return {Lane<Widths>::Ones(), Lane<Widths>::Zero()}; }
};

/// Returns ln of the sum over the widths of e^exponent/√determinant, and the most likely width. |1 + w² G/v|
/// and cᵀ (v/w² + G)⁻¹ c follow by elimination from the first column to the last.
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
  double coupling = 0;  // inner product with the previous column
  SharedPart<Taken, Widths> part(columns.shared.cols());
  for (Index i = 0; i < count; ++i) {
    const Lane pivot = narrow + columns.diagonal[i] - coupling * step;
    const Lane inverse = pivot.inverse();
    determinant *= w2 * pivot;
    if (determinant.maxCoeff() > 1e200) {
      exponents -= determinant.log() / 2;
      determinant.setOnes();
    }
    right = columns.right[i] - step * right;
    const Lane scaled = inverse * right;
    quadratic += scaled * right;
    part.add(columns.shared, i, step, inverse, scaled);
    coupling = i + 1 < count ? columns.subdiagonal[i] : 0;
    step = coupling * inverse;
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

}  // namespace alidade
