#include "core/adjustment/arc/arc_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/adjustment/arc/arc_checks.h"
#include "core/adjustment/arc/first_fit.h"
#include "core/adjustment/arc/visit_feet.h"
#include "core/adjustment/numerics/algebraic_circle.h"
#include "core/adjustment/numerics/least_squares.h"
#include "core/base/square.h"
#include "core/observation/visits.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

struct NormalEquations {
  std::optional<VisitFeet> feet = {};
  Matrix3d matrix = Matrix3d::Zero();
  Vector3d rightSide = Vector3d::Zero();
  double chiSquare = 0;  // of the visit means
};

/// The `Problem` of `minimise`. Every visit is at its foot point, which makes λ reliable even at the start.
class ArcProblem {
 public:
  using State = Circle;
  using System = NormalEquations;

  ArcProblem(const ArcView& view, const ArcMeasurement& arc, const ZeroLine& line)
      : m_visits(visitsOf(arc)), m_feet(view) {
    m_feet.reserve(m_visits.size());
    for (const Visit& visit : m_visits)
      m_feet.add(VisitReading(line.levelled(visit.mean.direction), visit.mean.rows));
  }

  const std::vector<Visit>& visits() const { return m_visits; }
  const Whitening& whitening() const { return m_feet.view().whitening; }

  std::vector<PlanePoint<double>> sightedPoints() const {
    std::vector<PlanePoint<double>> points;
    points.reserve(m_visits.size());
    for (std::size_t v = 0; v < m_visits.size(); ++v)
      points.push_back(sightedPoint(m_feet.view(), m_feet.reading(v)));
    return points;
  }

  NormalEquations system(const Circle& circle, NormalEquations used = {}) const {
    NormalEquations equations{.feet = used.feet ? std::move(used.feet) : m_feet};
    const ArcEquations own = equations.feet->converge({circle}, VisitFeet::From::Plane);
    using Whole = Eigen::Matrix<double, ArcEquations::estimated, ArcEquations::columns, Eigen::RowMajor>;
    equations.matrix = Eigen::Map<const Whole>(own.normal.front().data()).topLeftCorner<3, 3>();
    equations.rightSide = Eigen::Map<const Vector3d>(own.rightSide.data());
    equations.chiSquare = own.chiSquare;
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
  std::vector<Visit> m_visits;
  VisitFeet m_feet;  // without slider readings; `system` converges copies
};

void fillCovariance(ArcFit& fit, const NormalEquations& equations) {
  const Matrix3d cofactor = equations.matrix.inverse();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) fit.cofactor[i][j] = (cofactor(i, j) + cofactor(j, i)) / 2;
}

void fillResiduals(ArcFit& fit, const ArcProblem& problem, const ArcMeasurement& arc, const VisitFeet& feet) {
  fit.residuals.resize(arc.sightings.size());
  double sumOfSquares = 0;
  for (std::size_t v = 0; v < feet.size(); ++v) {
    const double phi = feet.arcAngle(v);
    const Direction<double> left = feet.left(v);
    const auto& [a, e] = problem.visits()[v].mean.direction;
    for (const std::size_t i : problem.visits()[v].sightings) {
      const Sighting& sighting = arc.sightings[i];
      const Angle horizontal = sighting.a - Angle::fromRadians(a - left.a);
      const Angle vertical = sighting.e - Angle::fromRadians(e - left.e);
      fit.residuals[i] = {sighting.row, phi, horizontal, vertical};
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
  const ZeroLine line(measurement, arc);
  const ArcProblem problem(view, arc, line);
  Circle circle = fit.circle;
  circle.y += line.height();
  fillResiduals(fit, problem, arc, *problem.system(circle).feet);
}

Result<ArcFit, ArcFault> fitArc(const Measurement& measurement, const ArcMeasurement& arc,
                                const ArcFitOptions& options) {
  const ZeroLine line(measurement, arc);
  const ArcProblem problem(ArcView(measurement, arc.axisDeg), arc, line);
  if (const auto fault = tooFewPlaces(measurement, problem.sightedPoints())) return *fault;
  std::optional<Circle> start = options.start;
  if (start) start->y += line.height();
  if (!start)  // the general equations confirm this start
    if (const auto fast = fitVisitsFast(measurement, problem.visits(), line)) start = fast->circle;
  if (!start) start = algebraicCircle(problem.sightedPoints());
  if (!start) return ArcFault(arc_fault::PlacesOnALine{});

  const auto minimum = minimise(
      problem, *start, {.maximumIterations = options.maximumIterations, .tolerance = options.tolerance});
  ArcFit fit;
  fit.position = arc.position;
  fit.axisDeg = arc.axisDeg;
  fit.repeat = arc.repeat;
  fit.degreesOfFreedom = static_cast<int>(2 * arc.sightings.size() - problem.visits().size()) - 3;
  fit.circle = minimum.state;
  fit.circle.y -= line.height();
  fit.iterations = minimum.iterations;
  fit.status = minimum.status;
  fillCovariance(fit, minimum.system);
  fillResiduals(fit, problem, arc, *minimum.system.feet);
  if (const auto fault = radiusUndetermined(fit)) return *fault;
  return fit;
}

}  // namespace alidade
