#include "core/adjustment/arc/arc_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/arc/arc_checks.h"
#include "core/adjustment/arc/first_fit.h"
#include "core/adjustment/arc/foot_point.h"
#include "core/adjustment/numerics/algebraic_circle.h"
#include "core/adjustment/numerics/least_squares.h"
#include "core/base/square.h"
#include "core/observation/visits.h"

namespace alidade {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

struct NormalEquations {
  std::vector<FootPoint> feet = {};  // of each visit
  Matrix3d matrix = Matrix3d::Zero();
  Vector3d rightSide = Vector3d::Zero();
  double chiSquare = 0;  // of the visit means
};

/// As `minimise` wants it: every visit stands at its foot point, so that λ is to be relied on at once.
class ArcProblem {
 public:
  using State = Circle;
  using System = NormalEquations;

  ArcProblem(const ArcView& view, const ArcMeasurement& arc) : m_view(view), m_visits(visitsOf(arc)) {
    m_readings.reserve(m_visits.size());
    for (const Visit& visit : m_visits) m_readings.emplace_back(visit.mean.direction, visit.mean.rows);
  }

  const std::vector<Visit>& visits() const { return m_visits; }
  const Whitening& whitening() const { return m_view.whitening; }

  std::vector<FootPoint> feetOn(const Circle& circle, std::vector<FootPoint> feet = {}) const {
    feet.clear();
    feet.reserve(m_readings.size());
    for (const VisitReading& reading : m_readings) feet.push_back(footPoint(m_view, {circle}, reading));
    return feet;
  }

  std::vector<PlanePoint<double>> sightedPoints() const {
    std::vector<PlanePoint<double>> points;
    points.reserve(m_readings.size());
    for (const VisitReading& reading : m_readings) points.push_back(sightedPoint(m_view, reading));
    return points;
  }

  NormalEquations system(const Circle& circle, NormalEquations used) const {
    NormalEquations equations{.feet = feetOn(circle, std::move(used.feet))};
    for (std::size_t v = 0; v < m_readings.size(); ++v) {
      const DistanceFromArc off = distanceFromArc(m_view, circle.radius, equations.feet[v]);
      const Vector3d gradient(off.gradient[0], off.gradient[1], off.gradient[2]);
      const Vector3d weighted = m_readings[v].rows * gradient;
      equations.matrix += weighted * gradient.transpose();
      equations.rightSide += weighted * off.distance;
      equations.chiSquare += m_readings[v].rows * off.distance * off.distance;
    }
    return equations;
  }

  double remaining(const NormalEquations& equations) const {
    const double squared = equations.rightSide.dot(equations.matrix.ldlt().solve(equations.rightSide));
    return squared >= 0 ? std::sqrt(squared) : std::numeric_limits<double>::infinity();
  }

  Circle moved(const Circle& circle, const NormalEquations& equations, double damping) const {
    Matrix3d damped = equations.matrix;
    damped.diagonal() *= 1 + damping;
    const Vector3d step = damped.ldlt().solve(equations.rightSide);
    return {circle.x + step[0], circle.y + step[1], circle.radius + step[2]};
  }

  bool isPossible(const Circle& circle) const { return circle.radius > 0; }

 private:
  ArcView m_view;
  std::vector<Visit> m_visits;
  std::vector<VisitReading> m_readings;  // without the slider's
};

void fillCovariance(ArcFit& fit, const NormalEquations& equations) {
  const Matrix3d cofactor = equations.matrix.inverse();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) fit.cofactor[i][j] = (cofactor(i, j) + cofactor(j, i)) / 2;
}

void fillResiduals(ArcFit& fit, const ArcProblem& problem, const ArcMeasurement& arc,
                   const std::vector<FootPoint>& feet) {
  fit.residuals.resize(arc.sightings.size());
  double sumOfSquares = 0;
  for (std::size_t v = 0; v < feet.size(); ++v) {
    const FootPoint& foot = feet[v];
    const auto& [a, e] = problem.visits()[v].mean.direction;
    for (const std::size_t i : problem.visits()[v].sightings) {
      const Sighting& sighting = arc.sightings[i];
      const Angle horizontal = sighting.a - Angle::fromRadians(a - foot.left.a);
      const Angle vertical = sighting.e - Angle::fromRadians(e - foot.left.e);
      fit.residuals[i] = {sighting.row, wrapped(Angle::fromRadians(foot.phi)).radians(), horizontal,
                          vertical};
      sumOfSquares += square(horizontal.arcseconds()) + square(vertical.arcseconds());
      fit.chiSquare += square(horizontal.radians() * problem.whitening().horizontal) +
                       square(vertical.radians() * problem.whitening().vertical);
    }
  }
  const auto readings = static_cast<int>(2 * arc.sightings.size());
  fit.residualRms = readings > 0 ? std::sqrt(sumOfSquares / readings) : 0;
}

}  // namespace

void fillResiduals(ArcFit& fit, const Measurement& measurement, const ArcMeasurement& arc,
                   VerticalAngleRelation relation) {
  ArcView view(measurement, arc.axisDeg);
  view.relation = relation;
  const ArcProblem problem(view, arc);
  fillResiduals(fit, problem, arc, problem.feetOn(fit.circle));
}

Result<ArcFit, ArcFault> fitArc(const Measurement& measurement, const ArcMeasurement& arc,
                                const ArcFitOptions& options) {
  const ArcProblem problem(ArcView(measurement, arc.axisDeg), arc);
  if (const auto fault = tooFewPlaces(measurement, problem.sightedPoints())) return *fault;
  std::optional<Circle> start = options.start;
  if (!start)  // to be confirmed by the general equations
    if (const auto fast = fitVisitsFast(measurement, problem.visits())) start = fast->circle;
  if (!start) start = algebraicCircle(problem.sightedPoints());
  if (!start) return ArcFault(arc_fault::PlacesOnALine{});

  const auto minimum = minimise(
      problem, *start, {.maximumIterations = options.maximumIterations, .tolerance = options.tolerance});
  ArcFit fit;
  fit.position = arc.position;
  fit.axisDeg = arc.axisDeg;
  fit.time = arc.time;
  fit.degreesOfFreedom = static_cast<int>(2 * arc.sightings.size() - problem.visits().size()) - 3;
  fit.circle = minimum.state;
  fit.iterations = minimum.iterations;
  fit.status = minimum.status;
  fillCovariance(fit, minimum.system);
  fillResiduals(fit, problem, arc, minimum.system.feet);
  if (const auto fault = radiusUndetermined(fit)) return *fault;
  return fit;
}

}  // namespace alidade
