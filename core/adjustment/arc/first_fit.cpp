#include "core/adjustment/arc/first_fit.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/adjustment/arc/arc_checks.h"
#include "core/adjustment/arc/foot_point.h"
#include "core/base/square.h"

namespace alidade {

namespace {

/// Σ (v/σ)², where v is the reading of a row minus the mean of its visit.
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

/// Do at least three places differ? Stops at the third.
bool areApart(const Measurement& measurement, const ZeroLine& line, const std::vector<Visit>& visits) {
  DifferentPlaces different(measurement);
  return std::ranges::any_of(visits, [&](const Visit& visit) {
    return different.areEnoughWith(line.sightedPoint(visit.mean.direction));
  });
}

}  // namespace

std::optional<FastArcFit> fitVisitsFast(const Measurement& measurement, const std::vector<Visit>& visits,
                                        const ZeroLine& line) {
  const std::size_t count = visits.size();
  std::vector<double> columns(3 * count);
  const std::span<double> all(columns);
  const auto a = all.first(count), e = all.subspan(count, count), rows = all.last(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Direction<double> level = line.levelled(visits[i].mean.direction);
    a[i] = level.a;
    e[i] = level.e;
    rows[i] = visits[i].mean.rows;
  }
  const ArcSetup setup{measurement.distance, measurement.sigmaHorizontal.radians(),
                       measurement.sigmaVertical.radians(), measurement.relation};
  return fitArcFast(setup, a, e, rows);
}

Result<ArcFit, ArcFault> firstFit(const Measurement& measurement, const ArcMeasurement& arc) {
  constexpr double surelyDetermined = 0.1;  // of R; `radiusUndetermined` allows a third
  const std::vector<Visit> visits = visitsOf(arc);
  const ArcView view(measurement, arc.axisDeg);
  const ZeroLine line(measurement, arc);
  const auto fast = fitVisitsFast(measurement, visits, line);
  if (!fast || !(std::sqrt(fast->cofactor[2][2]) < surelyDetermined * fast->circle.radius) ||
      !areApart(measurement, line, visits))
    return fitArc(measurement, arc);
  ArcFit fit;
  fit.position = arc.position;
  fit.axisDeg = arc.axisDeg;
  fit.repeat = arc.repeat;
  fit.degreesOfFreedom = static_cast<int>(2 * arc.sightings.size() - visits.size()) - 3;
  fit.circle = fast->circle;
  fit.circle.y -= line.height();
  fit.cofactor = fast->cofactor;
  fit.chiSquare = fast->chiSquare + chiSquareWithinVisits(view.whitening, arc, visits);
  fit.iterations = fast->iterations;
  fit.status = FitStatus::Converged;
  fit.residuals.resize(arc.sightings.size());
  for (std::size_t i = 0; i < arc.sightings.size(); ++i) fit.residuals[i].row = arc.sightings[i].row;
  return fit;
}

}  // namespace alidade
