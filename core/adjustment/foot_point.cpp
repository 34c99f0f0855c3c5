#include "core/adjustment/foot_point.h"

#include <Eigen/Core>
#include <cmath>

#include "core/adjustment/auto_diff.h"

namespace alidade {

namespace {

using Jet = Eigen::AutoDiffScalar<Eigen::Matrix<double, 4, 1>>;  // Δx, Δy, R, φ
using Eigen::Vector2d;

struct WhitenedModel {
  Direction<double> reading;
  Eigen::Matrix<double, 2, 4> jacobian;
};

WhitenedModel modelAt(const Circle& circle, double distance, VerticalAngleRelation relation,
                      const Whitening& whitening, double phi) {
  const Jet x(circle.x, 4, 0), y(circle.y, 4, 1), radius(circle.radius, 4, 2), angle(phi, 4, 3);
  const Jet l(distance, Jet::DerType::Zero());
  const Direction<Jet> reading = observe(targetOnArc(x, y, radius, angle), l, relation);
  WhitenedModel model{{reading.a.value(), reading.e.value()}, {}};
  model.jacobian.row(0) = whitening.horizontal * reading.a.derivatives().transpose();
  model.jacobian.row(1) = whitening.vertical * reading.e.derivatives().transpose();
  return model;
}

Vector2d whitenedResidual(const Direction<double>& sighted, const Direction<double>& model,
                          const Whitening& whitening) {
  return {whitening.horizontal * (sighted.a - model.a), whitening.vertical * (sighted.e - model.e)};
}

}  // namespace

FootPoint footPoint(const Circle& circle, double distance, VerticalAngleRelation relation,
                    const Whitening& whitening, const Direction<double>& sighted) {
  constexpr int maximumIterations = 25;
  constexpr double smallestStep = 1e-14;  // rad; 4e-12 mm on a 400 mm arc
  constexpr double largestStep = 0.3;     // rad; keeps a poor start on its side of the circle

  double phi = nearestArcAngle(circle, sightedPoint(sighted, distance, relation));
  WhitenedModel model = modelAt(circle, distance, relation, whitening, phi);
  for (int i = 0; i < maximumIterations; ++i) {
    const Vector2d along = model.jacobian.col(3);
    const double step = along.dot(whitenedResidual(sighted, model.reading, whitening)) / along.squaredNorm();
    phi += std::clamp(step, -largestStep, largestStep);
    model = modelAt(circle, distance, relation, whitening, phi);
    if (std::abs(step) < smallestStep) break;
  }

  const Vector2d along = model.jacobian.col(3).normalized();
  const Vector2d normal(along.y(), -along.x());
  FootPoint foot;
  foot.phi = phi;
  foot.adjusted = model.reading;
  foot.distance = normal.dot(whitenedResidual(sighted, model.reading, whitening));
  for (int i = 0; i < 3; ++i) foot.gradient[i] = normal.dot(model.jacobian.col(i));
  return foot;
}

}  // namespace alidade
