#include "core/adjustment/arc/arc_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/arc/arc_findings.h"
#include "core/adjustment/arc/first_fit.h"
#include "core/adjustment/arc/foot_point.h"
#include "core/adjustment/numerics/algebraic_circle.h"
#include "core/observation/visits.h"

namespace alidade {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

double square(double value) {
  return value * value;
}

struct NormalEquations {
  std::vector<FootPoint> feet;  // of each visit
  Matrix3d matrix = Matrix3d::Zero();
  Vector3d rightSide = Vector3d::Zero();
  double chiSquare = 0;  // of the visit means
};

class ArcProblem {
 public:
  ArcProblem(const Measurement& measurement, const ArcMeasurement& arc)
      : m_view(measurement, arc.axisDeg), m_visits(visitsOf(arc)) {
    m_readings.reserve(m_visits.size());
    for (const Visit& visit : m_visits) m_readings.emplace_back(visit.mean.direction, visit.mean.rows);
  }

  const std::vector<Visit>& visits() const { return m_visits; }
  const Whitening& whitening() const { return m_view.whitening; }

  std::vector<FootPoint> feetOn(const Circle& circle) const {
    std::vector<FootPoint> feet;
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

  NormalEquations normalEquations(const Circle& circle) const {
    NormalEquations equations{.feet = feetOn(circle)};
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

 private:
  ArcView m_view;
  std::vector<Visit> m_visits;
  std::vector<VisitReading> m_readings;  // without the slider's
};

struct Solution {
  Circle circle;
  NormalEquations equations;
  int iterations = 0;
  bool converged = false;
};

Circle moved(const Circle& circle, const Vector3d& step) {
  return {circle.x + step[0], circle.y + step[1], circle.radius + step[2]};
}

/// The length of the undamped step in standard deviations of the result.
double remainingStep(const NormalEquations& equations) {
  const double squared = equations.rightSide.dot(equations.matrix.ldlt().solve(equations.rightSide));
  return squared >= 0 ? std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

/// Levenberg-Marquardt; the damping is relative to the diagonal, so it does not depend on units.
Solution minimise(const ArcProblem& problem, const Circle& start, const ArcFitOptions& options) {
  Solution best{start, problem.normalEquations(start), 0, false};
  constexpr double largestDamping = 1e12, smallestDamping = 1e-12;
  // Readings are rounded to 1e-16 rad, some 1e-11 of their σ: a rise of χ² by less is none.
  constexpr double rounding = 1e-9;
  double damping = 1e-6;
  while (!(best.converged = remainingStep(best.equations) < options.tolerance) &&
         best.iterations < options.maximumIterations && damping < largestDamping) {
    ++best.iterations;
    Matrix3d damped = best.equations.matrix;
    damped.diagonal() *= 1 + damping;
    const Circle trial = moved(best.circle, damped.ldlt().solve(best.equations.rightSide));
    if (trial.radius > 0) {
      NormalEquations equations = problem.normalEquations(trial);
      if (equations.chiSquare <= best.equations.chiSquare + rounding * (1 + best.equations.chiSquare)) {
        best.circle = trial;
        best.equations = std::move(equations);
        damping = std::max(damping / 10, smallestDamping);
        continue;
      }
    }
    damping *= 10;
  }
  return best;
}

void fillCovariance(ArcFit& fit, const NormalEquations& equations) {
  const Matrix3d cofactor = equations.matrix.inverse();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) fit.cofactor[i][j] = (cofactor(i, j) + cofactor(j, i)) / 2;
}

Problem unfit(const ArcMeasurement& arc, std::string sentence) {
  return {std::move(sentence), Place{.position = arc.position, .reading = {}, .field = "readings"}};
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

void fillResiduals(ArcFit& fit, const Measurement& measurement, const ArcMeasurement& arc) {
  const ArcProblem problem(measurement, arc);
  fillResiduals(fit, problem, arc, problem.feetOn(fit.circle));
}

Result<ArcFit> fitArc(const Measurement& measurement, const ArcMeasurement& arc,
                      const ArcFitOptions& options) {
  const ArcProblem problem(measurement, arc);
  if (auto sentence = tooFewPlaces(measurement, problem.sightedPoints())) return unfit(arc, *sentence);
  std::optional<Circle> start = options.start;
  if (!start)  // to be confirmed by the general equations
    if (const auto fast = fitVisitsFast(measurement, problem.visits())) start = fast->circle;
  if (!start) start = algebraicCircle(problem.sightedPoints());
  if (!start) return unfit(arc, straightLineSentence());

  const Solution solution = minimise(problem, *start, options);
  ArcFit fit;
  fit.position = arc.position;
  fit.axisDeg = arc.axisDeg;
  fit.degreesOfFreedom = static_cast<int>(2 * arc.sightings.size() - problem.visits().size()) - 3;
  fit.circle = solution.circle;
  fit.iterations = solution.iterations;
  fit.converged = solution.converged;
  fillCovariance(fit, solution.equations);
  fillResiduals(fit, problem, arc, solution.equations.feet);
  if (auto sentence = radiusUndetermined(fit)) return unfit(arc, *sentence);
  return fit;
}

}  // namespace alidade
