#include "core/adjustment/arc/published_fit.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <cmath>

#include "core/observation/visits.h"

namespace alidade {

namespace {

using Column = Eigen::VectorXd;

/// The observation columns at the start values: tangents and plane coordinates with the paper's signs.
struct PaperColumns {
  Eigen::ArrayXd tanA, tanB, x, y;
};

PaperColumns columnsOf(const Measurement& measurement, const ArcMeasurement& arc) {
  const auto n = static_cast<Eigen::Index>(arc.sightings.size());
  // β as printed: zenith angles increase downwards.
  const double sign = measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1;
  PaperColumns columns{Eigen::ArrayXd(n), Eigen::ArrayXd(n), {}, {}};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Sighting& sighting = arc.sightings[static_cast<std::size_t>(i)];
    columns.tanA[i] = std::tan(sighting.a.radians());
    columns.tanB[i] = sign * std::tan(sighting.e.radians());
  }
  columns.x = measurement.distance * columns.tanA;
  columns.y = measurement.distance * columns.tanB;
  return columns;
}

Eigen::MatrixXd designMatrix(const PaperColumns& c, double radius) {
  Eigen::MatrixXd phi(c.x.size(), 5);
  phi.col(0).setConstant(-2 * radius);
  phi.col(1) = -2 * c.x;
  phi.col(2) = -2 * c.y;
  phi.col(3) = 2 * c.y.square() * c.tanB - 2 * c.x * c.y * c.tanA;
  phi.col(4) = 2 * c.x.square() * c.tanA - 2 * c.x * c.y * c.tanB;
  return phi;
}

}  // namespace

Result<PublishedFit, ArcFault> fitArcAsPublished(const Measurement& measurement, const ArcMeasurement& arc) {
  constexpr int unknowns = 5, iterations = 2;
  constexpr double printedStep = 1e-4;  // mm, the last digit that is printed
  const int places = static_cast<int>(visitsOf(arc).size());
  if (places < unknowns) return ArcFault(arc_fault::TooFewForPublished{places});

  const PaperColumns columns = columnsOf(measurement, arc);
  double radius = measurement.nominalRadius;
  Eigen::VectorXd unknown(unknowns);
  for (int i = 0; i < iterations; ++i) {
    const auto solver = designMatrix(columns, radius).colPivHouseholderQr();
    if (solver.rank() < unknowns) return ArcFault(arc_fault::NoUniqueSolution{});
    unknown = solver.solve((radius * radius - columns.x.square() - columns.y.square()).matrix());
    radius += unknown[0];
  }
  if (!(radius > 0) || !unknown.allFinite()) return ArcFault(arc_fault::NoPublishedCircle{});

  PublishedFit fit;
  fit.asPrinted = {unknown[0], unknown[1], unknown[2], unknown[3], unknown[4]};
  const double up = measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1;
  fit.arc.position = arc.position;
  fit.arc.axisDeg = arc.axisDeg;
  fit.arc.repeat = arc.repeat;
  fit.arc.circle = {unknown[1], up * unknown[2], radius};
  fit.arc.iterations = iterations;
  fit.arc.status =
      std::abs(fit.asPrinted.deltaRadius) < printedStep ? FitStatus::Converged : FitStatus::TooManyIterations;
  fit.arc.degreesOfFreedom = static_cast<int>(2 * arc.sightings.size()) - places - unknowns;
  fillResiduals(fit.arc, measurement, arc, VerticalAngleRelation::Planar);
  return fit;
}

}  // namespace alidade
