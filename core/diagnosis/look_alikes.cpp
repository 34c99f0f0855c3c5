#include "core/diagnosis/look_alikes.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/diagnosis/explanation.h"

namespace alidade {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// A bending effect leaves its second derivatives only together; the nearest is sought by Gauss-Newton from
/// several sides.
double differenceFromBent(const VectorXd& trace, const Component& component) {
  constexpr double sides[][2] = {{3, 0}, {0, 3}, {2, 2}, {2, -2}, {0.1, 0.1}};
  const MatrixXd columns = bentColumns(component);
  const MatrixXd gram = columns.transpose() * columns;
  const VectorXd right = columns.transpose() * trace;
  double least = trace.squaredNorm();
  for (const auto& side : sides) {
    VectorXd weights = Eigen::Vector2d(side[0], side[1]);
    for (int i = 0; i < 12; ++i) {
      const VectorXd bent = bentWeights(weights), left = right - gram * bent;
      least = std::min(least, trace.squaredNorm() - bent.dot(right + left));
      const auto derivatives = bentDerivatives(weights);
      MatrixXd normal = derivatives.transpose() * gram * derivatives;
      normal.diagonal().array() += 1e-6 * normal.trace() + 1e-12;
      weights += normal.ldlt().solve(derivatives.transpose() * left);
      weights = weights.cwiseMax(-20).cwiseMin(20);
    }
  }
  return std::sqrt(std::max(least, 0.0));
}

}  // namespace

double differenceFrom(const VectorXd& trace, const Component& component) {
  if (component.allOrNothing) {
    const double size = component.columns.squaredNorm();
    return size == 0 ? trace.norm() : std::min(trace.norm(), (trace - component.columns.col(0)).norm());
  }
  if (component.curvature.cols() > 0) return differenceFromBent(trace, component);
  MatrixXd columns(component.columns.rows(), 0);
  for (Eigen::Index c = 0; c < component.columns.cols(); ++c) {
    const double norm = component.columns.col(c).norm();
    if (norm < 1e-9) continue;
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    columns.rightCols(1) = component.columns.col(c) / norm;
  }
  if (columns.cols() == 0) return trace.norm();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  return (trace - columns * qr.solve(trace)).norm();
}

LookAlike compared(const VectorXd& trace, const Component& component) {
  const double difference = differenceFrom(trace, component), length = trace.norm();
  const double share = length > 0 ? difference / length : 1;
  return {std::string(component.id), std::sqrt(std::max(0.0, 1 - share * share)), difference};
}

}  // namespace alidade
