#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "core/adjustment/arc/fast_arc_fit.h"
#include "core/base/angle.h"
#include "core/base/random_source.h"
#include "core/observation/perfect_theodolite.h"

// The distance of the fast fit of an arc from the minimum, over random arcs: spans of 30° to 350°, radii of
// 100 to 500 mm, distances of 0.6 to 24 m, noise of 0.1″ to 30″, both vertical angle relations. The reference
// minimum uses 64-bit mantissas and Gauss-Newton with an arc angle for each place. The limit is 1e-9 mm.
//
//   alidade_fast_agreement [ARCS [SEED]]

namespace {

using namespace alidade;
using Extended = long double;
using Vector3 = Eigen::Matrix<Extended, 3, 1>;
using Matrix3 = Eigen::Matrix<Extended, 3, 3>;

struct RandomArc {
  ArcSetup setup;
  std::vector<double> a, e;
};

RandomArc drawArc(RandomSource& random) {
  RandomArc arc;
  ArcSetup& setup = arc.setup;
  setup.distance = 600 * std::exp(random.uniform(0, std::log(40)));
  setup.relation = random.uniform() < 0.5 ? VerticalAngleRelation::Exact : VerticalAngleRelation::Planar;
  const double noise = 0.1 * std::exp(random.uniform(0, std::log(300)));
  const double ratio = random.uniform() < 0.5 ? 1 : std::exp(random.uniform(-1, 1));
  setup.sigmaHorizontal = Angle::fromArcseconds(noise).radians();
  setup.sigmaVertical = setup.sigmaHorizontal * ratio;
  const double x = random.uniform(-20, 20), y = random.uniform(-20, 20), radius = random.uniform(100, 500);
  const double degree = std::numbers::pi / 180;
  const double from = random.uniform(0, 360) * degree, span = random.uniform(30, 350) * degree;
  const int places = random.whole(4, 43);
  for (int i = 0; i < places; ++i) {
    const double phi = from + span * i / (places - 1);
    const auto seen = observe<double>({x + radius * std::cos(phi), y + radius * std::sin(phi)},
                                      setup.distance, setup.relation);
    arc.a.push_back(seen.a + setup.sigmaHorizontal * random.normal());
    arc.e.push_back(seen.e + setup.sigmaVertical * random.normal());
  }
  return arc;
}

/// The weighted residuals of a place at the angle φ of the circle, with their derivatives with respect to
/// circle (x, y, R) and φ.
struct Equation {
  Eigen::Matrix<Extended, 2, 3> byCircle;
  Eigen::Matrix<Extended, 2, 1> byAngle, left;
};

Equation equationAt(const RandomArc& arc, std::size_t i, const Vector3& circle, Extended phi) {
  const ArcSetup& setup = arc.setup;
  const Extended l = setup.distance, c = std::cos(phi), s = std::sin(phi);
  const Extended x = circle[0] + circle[2] * c, y = circle[1] + circle[2] * s;
  const Direction<Extended> seen = observe<Extended>({x, y}, l, setup.relation);
  const bool exact = setup.relation == VerticalAngleRelation::Exact;
  const Extended reach = exact ? std::hypot(x, l) : l, range = reach * reach + y * y;
  Eigen::Matrix<Extended, 2, 2> byPoint;
  byPoint << l / (l * l + x * x), 0, exact ? -x * y / (reach * range) : 0, reach / range;
  Eigen::Matrix<Extended, 2, 3> pointByCircle;
  pointByCircle << 1, 0, c, 0, 1, s;
  const Eigen::Matrix<Extended, 2, 1> pointByAngle{-circle[2] * s, circle[2] * c};
  const Eigen::Matrix<Extended, 2, 1> weight{1 / Extended{setup.sigmaHorizontal},
                                             1 / Extended{setup.sigmaVertical}};
  return {weight.asDiagonal() * byPoint * pointByCircle, weight.asDiagonal() * byPoint * pointByAngle,
          weight.cwiseProduct(Eigen::Matrix<Extended, 2, 1>{arc.a[i] - seen.a, arc.e[i] - seen.e})};
}

/// Moves the circle and the angles by one step; returns the step of the circle.
Vector3 improve(const RandomArc& arc, Vector3& circle, std::vector<Extended>& angles) {
  Matrix3 normal = Matrix3::Zero();
  Vector3 right = Vector3::Zero();
  std::vector<Equation> equations;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Equation& q = equations.emplace_back(equationAt(arc, i, circle, angles[i]));
    const Vector3 mixed = q.byCircle.transpose() * q.byAngle;
    const Extended own = q.byAngle.squaredNorm();
    normal += q.byCircle.transpose() * q.byCircle - mixed * mixed.transpose() / own;
    right += q.byCircle.transpose() * q.left - mixed * (q.byAngle.dot(q.left) / own);
  }
  const Vector3 step = normal.ldlt().solve(right);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Equation& q = equations[i];
    angles[i] += q.byAngle.dot(q.left - q.byCircle * step) / q.byAngle.squaredNorm();
  }
  circle += step;
  return step;
}

/// The minimum near `start`, mm.
Vector3 minimum(const RandomArc& arc, const Circle& start) {
  Vector3 circle{start.x, start.y, start.radius};
  std::vector<Extended> angles;
  for (std::size_t i = 0; i < arc.a.size(); ++i) {
    const PlanePoint<double> point =
        sightedPoint({arc.a[i], arc.e[i]}, arc.setup.distance, arc.setup.relation);
    angles.push_back(std::atan2(point.y - start.y, point.x - start.x));
  }
  constexpr int mostSteps = 100;
  for (int i = 0; i < mostSteps; ++i)
    if (improve(arc, circle, angles).norm() < 1e-14L) break;
  return circle;
}

struct Tally {
  int fitted = 0, beyond = 0;
  double worst = 0;

  void add(double difference) {
    ++fitted;
    worst = std::max(worst, difference);
    if (difference > 1e-9) ++beyond;
  }

  void print(const char* which) const {
    std::printf("%-10s %8d fits, worst %.2g mm, beyond 1e-9 mm: %d\n", which, fitted, worst, beyond);
  }
};

}  // namespace

int main(int argc, char** argv) {
  const int arcs = argc > 1 ? std::atoi(argv[1]) : 20000;
  RandomSource random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  Tally oneStep, iterated;
  for (int i = 0; i < arcs; ++i) {
    const RandomArc arc = drawArc(random);
    const auto fast = fitArcFast(arc.setup, arc.a, arc.e);
    if (!fast) continue;
    const Vector3 found{fast->circle.x, fast->circle.y, fast->circle.radius};
    const auto difference = static_cast<double>((found - minimum(arc, fast->circle)).cwiseAbs().maxCoeff());
    (fast->iterations == 1 ? oneStep : iterated).add(difference);
  }
  oneStep.print("one step");
  iterated.print("iterated");
}
