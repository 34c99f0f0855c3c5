#include "core/diagnosis/observability/look_alikes.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

using Eigen::MatrixXd, Eigen::VectorXd;

Trace::Trace(const Leftover& leftover, VectorXd visible)
    : m_leftover(leftover), m_visible(std::move(visible)), m_ofTerms(leftover.productsOfTerms(m_visible)) {}

/// By normal equations. They have half the digits: what is much nearer than the trace is long, is measured.
double Trace::differenceFrom(const Component& effect) const {
  constexpr double invisible = 1e-9, rounding = 1e-11,
                   near = 1e-3;  // σ; of the greatest pivot; of the length
  const VectorXd right = productsWith(m_visible, m_ofTerms, effect);
  if (effect.curvature.cols() > 0) return differenceFromBent(effect, right);
  VectorXd weights = VectorXd::Ones(1);
  if (!effect.allOrNothing) {
    const VectorXd lengths = effect.gram.diagonal().cwiseMax(0).cwiseSqrt();
    const VectorXd scale =
        (lengths.array() < invisible).select(0, lengths.cwiseMax(invisible).cwiseInverse());
    Eigen::ColPivHouseholderQR<MatrixXd> normal(scale.asDiagonal() * effect.gram * scale.asDiagonal());
    normal.setThreshold(rounding);
    weights = scale.cwiseProduct(normal.solve(scale.cwiseProduct(right)));
  }
  const double square = m_visible.squaredNorm(),
               left = square - weights.dot(2 * right - effect.gram * weights);
  if (left > near * near * square) return std::sqrt(std::min(left, square));
  return (m_visible - signature(m_leftover, effect, weights)).norm();
}

/// A bending effect leaves its second derivatives only together; the nearest is sought by Gauss-Newton from
/// several sides.
double Trace::differenceFromBent(const Component& effect, const VectorXd& right) const {
  constexpr double sides[][2] = {{3, 0}, {0, 3}, {2, 2}, {2, -2}, {0.1, 0.1}};
  const MatrixXd& gram = effect.bentGram;
  const double square = m_visible.squaredNorm();
  double least = square;
  for (const auto& side : sides) {
    VectorXd weights = Eigen::Vector2d(side[0], side[1]);
    for (int i = 0; i < 12; ++i) {
      const VectorXd bent = bentWeights(weights), left = right - gram * bent;
      least = std::min(least, square - bent.dot(right + left));
      const auto derivatives = bentDerivatives(weights);
      MatrixXd normal = derivatives.transpose() * gram * derivatives;
      normal.diagonal().array() += 1e-6 * normal.trace() + 1e-12;
      weights += normal.ldlt().solve(derivatives.transpose() * left);
      weights = weights.cwiseMax(-20).cwiseMin(20);
    }
  }
  return std::sqrt(std::max(least, 0.0));
}

LookAlike Trace::compared(const Component& effect) const {
  const double difference = differenceFrom(effect), whole = length();
  const double share = whole > 0 ? difference / whole : 1;
  return {std::string(effect.id), std::sqrt(std::max(0.0, 1 - share * share)), difference};
}

}  // namespace alidade
