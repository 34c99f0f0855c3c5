#include "core/diagnosis/observability/look_alikes.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/diagnosis/evidence/bent_fit.h"

namespace alidade {

using Eigen::MatrixXd, Eigen::VectorXd;

/// The second-order terms of a bent effect follow from its weights, so the distance may have several minima.
/// Gauss-Newton searches the nearest trace from several start points.
double differenceFromBent(const MatrixXd& gram, const VectorXd& right, double square) {
  constexpr double sides[][2] = {{3, 0}, {0, 3}, {2, 2}, {2, -2}, {0.1, 0.1}};
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

Trace::Trace(const Leftover& leftover, VectorXd visible)
    : m_visible(std::move(visible)), m_products(leftover, m_visible) {}

/// Normal equations lose half of the digits: a distance much shorter than the trace is computed directly.
double Trace::differenceFrom(const Component& effect) const {
  constexpr double invisible = 1e-9, rounding = 1e-11,
                   near = 1e-3;  // σ; relative to the largest pivot; relative to the length
  const VectorXd right = effect.products(m_products);
  if (effect.response() == Response::Bent)
    return differenceFromBent(effect.gram(), right, m_visible.squaredNorm());
  const MatrixXd gram = effect.gram();
  VectorXd weights = VectorXd::Ones(1);
  if (effect.response() != Response::AllOrNothing) {
    const VectorXd lengths = gram.diagonal().cwiseMax(0).cwiseSqrt();
    const VectorXd scale =
        (lengths.array() < invisible).select(0, lengths.cwiseMax(invisible).cwiseInverse());
    Eigen::ColPivHouseholderQR<MatrixXd> normal(scale.asDiagonal() * gram * scale.asDiagonal());
    normal.setThreshold(rounding);
    weights = scale.cwiseProduct(normal.solve(scale.cwiseProduct(right)));
  }
  const double square = m_visible.squaredNorm(), left = square - weights.dot(2 * right - gram * weights);
  if (left > near * near * square) return std::sqrt(std::min(left, square));
  return (m_visible - effect.signature(m_products.leftover(), weights)).norm();
}

LookAlike Trace::compared(const Component& effect) const {
  const double difference = differenceFrom(effect), whole = length();
  const double share = whole > 0 ? difference / whole : 1;
  return {std::string(effect.id()), std::sqrt(std::max(0.0, 1 - share * share)), difference};
}

}  // namespace alidade
