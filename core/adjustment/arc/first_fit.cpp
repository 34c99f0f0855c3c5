#include "core/adjustment/arc/first_fit.h"

#include <cmath>

#include "core/adjustment/arc/arc_checks.h"
#include "core/adjustment/arc/foot_point.h"
#include "core/base/square.h"

namespace alidade {

namespace {

/// Σ (v/σ)² of what the rows of each visit differ by.
double chiSquareWithinVisits(const Whitening& whitening, const ArcMeasurement& arc,
                             const std::vector<Visit>& visits) {
  double sum = 0;
  for (const Visit& visit : visits) {
    if (visit.sightings.size() < 2) continue;
    for (const std::size_t i : visit.sightings)
      sum += square((arc.sightings[i].a.radians() - visit.mean.direction.a) * whitening.horizontal) +
             square((arc.sightings[i].e.radians() - visit.mean.direction.e) * whitening.vertical);
  }
  return sum;
}

/// Three of the places, far apart in time, are different ones. Others may be where these are not.
bool areApart(const Measurement& measurement, const ArcView& view, const std::vector<Visit>& visits) {
  if (visits.size() < 3) return false;
  std::vector<PlanePoint<double>> places;
  for (const std::size_t v : {std::size_t{0}, visits.size() / 2, visits.size() - 1})
    places.push_back(sightedPoint(view, VisitReading(visits[v].mean.direction)));
  return !tooFewPlaces(measurement, places);
}

}  // namespace

std::optional<FastArcFit> fitVisitsFast(const Measurement& measurement, const std::vector<Visit>& visits) {
  std::vector<double> a, e, rows;
  for (std::vector<double>* column : {&a, &e, &rows}) column->reserve(visits.size());
  for (const Visit& visit : visits) {
    a.push_back(visit.mean.direction.a);
    e.push_back(visit.mean.direction.e);
    rows.push_back(visit.mean.rows);
  }
  const ArcSetup setup{measurement.distance, measurement.sigmaHorizontal.radians(),
                       measurement.sigmaVertical.radians(), measurement.relation};
  return fitArcFast(setup, a, e, rows);
}

Result<ArcFit, ArcFault> firstFit(const Measurement& measurement, const ArcMeasurement& arc) {
  constexpr double surelyDetermined = 0.1;  // of R: the limit is a third
  const std::vector<Visit> visits = visitsOf(arc);
  const ArcView view(measurement, arc.axisDeg);
  const auto fast = fitVisitsFast(measurement, visits);
  if (!fast || !(std::sqrt(fast->cofactor[2][2]) < surelyDetermined * fast->circle.radius) ||
      !areApart(measurement, view, visits))
    return fitArc(measurement, arc);
  ArcFit fit;
  fit.position = arc.position;
  fit.axisDeg = arc.axisDeg;
  fit.time = arc.time;
  fit.degreesOfFreedom = static_cast<int>(2 * arc.sightings.size() - visits.size()) - 3;
  fit.circle = fast->circle;
  fit.cofactor = fast->cofactor;
  fit.chiSquare = fast->chiSquare + chiSquareWithinVisits(view.whitening, arc, visits);
  fit.iterations = fast->iterations;
  fit.status = FitStatus::Converged;
  fit.residuals.resize(arc.sightings.size());
  for (std::size_t i = 0; i < arc.sightings.size(); ++i) fit.residuals[i].row = arc.sightings[i].row;
  return fit;
}

}  // namespace alidade
