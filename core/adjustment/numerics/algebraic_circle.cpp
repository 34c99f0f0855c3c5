#include "core/adjustment/numerics/algebraic_circle.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace alidade {

std::optional<Circle> algebraicCircle(const std::vector<PlanePoint<double>>& points) {
  if (points.size() < 3) return std::nullopt;
  using Eigen::Matrix2d, Eigen::Vector2d;

  Vector2d mean = Vector2d::Zero();
  for (const auto& p : points) mean += Vector2d(p.x, p.y);
  mean /= static_cast<double>(points.size());

  Matrix2d scatter = Matrix2d::Zero();
  Vector2d skew = Vector2d::Zero();
  for (const auto& p : points) {
    const Vector2d d = Vector2d(p.x, p.y) - mean;
    scatter += d * d.transpose();
    skew += d * d.squaredNorm();
  }
  // The smaller eigenvalue grows with the square of the sagitta. At rounding error the points are on a line.
  const Vector2d spread = Eigen::SelfAdjointEigenSolver<Matrix2d>(scatter).eigenvalues();
  constexpr double straight = 1e-14;
  if (!(spread[0] > straight * spread[1])) return std::nullopt;

  const Vector2d centre = scatter.ldlt().solve(skew) / 2;
  const double radius =
      std::sqrt(centre.squaredNorm() + scatter.trace() / static_cast<double>(points.size()));
  if (!centre.allFinite() || !std::isfinite(radius)) return std::nullopt;
  return Circle{mean.x() + centre.x(), mean.y() + centre.y(), radius};
}

}  // namespace alidade
