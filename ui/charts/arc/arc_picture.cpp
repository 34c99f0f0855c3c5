#include "ui/charts/arc/arc_picture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/round_numbers.h"
#include "core/observation/zero_line.h"
#include "ui/charts/plotting/evaluation_pictures.h"

namespace alidade::ui {
namespace {

constexpr double largestShareOfRadius = 0.16;
constexpr double largestExaggeration = 1e6;

DrawnSighting drawnSighting(const Measurement& measurement, const ArcMeasurement& arc,
                            const Sighting& sighting) {
  return {.ref = {arc.position, sighting.row},
          .axisDeg = arc.axisDeg,
          .repeat = arc.repeat,
          .point = sighting.point,
          .round = sighting.round,
          .face = sighting.face,
          .sighted = ZeroLine(measurement, arc).sightedPoint(sighting),
          .adjusted = {}};
}

/// The fitted arc of one axis over the arc angles of all its sightings, unwrapped around the mean angle.
/// `first`: the first arc of this axis; all arcs of an axis share one circle.
DrawnArc drawnArc(const SessionFit& fit, const ArcFit& first) {
  MeanDirection mean;
  std::vector<double> angles;
  for (const ArcFit& arc : fit.arcs) {
    if (arc.axisDeg != first.axisDeg) continue;
    for (const SightingResidual& residual : arc.residuals) {
      angles.push_back(residual.arcAngle);
      mean.add(Angle::fromRadians(residual.arcAngle));
    }
  }
  const Angle middle = mean.value();
  DrawnArc drawn{first.axisDeg, first.circle, middle.radians(), middle.radians()};
  for (const double arcAngle : angles) {
    const double angle = wrapped(Angle::fromRadians(arcAngle), middle).radians();
    drawn.firstAngle = std::min(drawn.firstAngle, angle);
    drawn.lastAngle = std::max(drawn.lastAngle, angle);
  }
  return drawn;
}

/// The residual in the arc plane, mm: from the point of the adjusted angles to the point `sighted`.
PlanePoint<double> residualInPlane(const ZeroLine& line, const PlanePoint<double>& sighted,
                                   const Sighting& sighting, const SightingResidual& residual) {
  const Direction<double> adjusted{(sighting.a - residual.horizontal).radians(),
                                   (sighting.e - residual.vertical).radians()};
  const PlanePoint<double> from = line.sightedPoint(adjusted);
  return {sighted.x - from.x, sighted.y - from.y};
}

/// Adds the adjusted targets and the residuals to the sightings of one position, from index `first` on.
void addAdjusted(ArcPicture& picture, std::size_t first, const Measurement& measurement,
                 const ArcMeasurement& arc, const ArcFit& fit) {
  std::size_t next = first;
  for (const SightingResidual& residual : fit.residuals) {
    while (next < picture.sightings.size() && picture.sightings[next].ref.row != residual.row) ++next;
    if (next == picture.sightings.size()) return;
    DrawnSighting& drawn = picture.sightings[next];
    drawn.adjusted = targetOnArc(fit.circle.x, fit.circle.y, fit.circle.radius, residual.arcAngle);
    drawn.residual =
        residualInPlane(ZeroLine(measurement, arc), drawn.sighted, arc.sightings[next - first], residual);
  }
}

double pickExaggeration(const ArcPicture& picture) {
  double largest = 0, radius = 0;
  for (const DrawnArc& arc : picture.arcs) radius = std::max(radius, arc.circle.radius);
  for (const DrawnSighting& sighting : picture.sightings) {
    largest = std::max(largest, std::hypot(sighting.residual.x, sighting.residual.y));
  }
  if (largest <= 0 || !std::isfinite(largest)) return 1;
  return std::clamp(roundDown125(largestShareOfRadius * radius / largest), 1.0, largestExaggeration);
}

/// A session with only the excluded rows of `session`, marked as used. `rows` receives their row numbers.
Session excludedAlone(const Session& session, std::vector<std::vector<std::size_t>>& rows) {
  Session alone;
  alone.instrument = session.instrument;
  alone.environment = session.environment;
  alone.geometry = session.geometry;
  alone.model = session.model;
  for (const Position& position : session.positions) {
    alone.positions.push_back(
        {.axisDeg = position.axisDeg, .zero = position.zero, .readings = {}, .origin = {}});
    rows.emplace_back();
    for (std::size_t row = 0; row < position.readings.size(); ++row) {
      if (!position.readings[row].excluded) continue;
      rows.back().push_back(row);
      Reading& reading = alone.positions.back().readings.emplace_back(position.readings[row]);
      reading.excluded = false;
      if (reading.point.empty()) reading.point = std::to_string(row + 1);
    }
  }
  return alone;
}

/// The rows excluded by the user, with their points in the arc plane.
std::vector<DrawnSighting> excludedSightings(const Session& session) {
  std::vector<std::vector<std::size_t>> rows;
  const Examined examined = examine(excludedAlone(session, rows));
  std::vector<DrawnSighting> excluded;
  if (!examined.measurement) return excluded;
  for (const ArcMeasurement& arc : examined.measurement->arcs) {
    for (const Sighting& sighting : arc.sightings) {
      excluded.push_back(drawnSighting(*examined.measurement, arc, sighting));
      excluded.back().ref.row = rows[arc.position][sighting.row];
    }
  }
  return excluded;
}

/// The ellipse of the centre of arc `arc` in the joint fit.
DrawnEllipse ellipseOfCentre(const SessionFit& fit, std::size_t arc) {
  const auto variance = [&](double perX, double perY) {
    std::vector<double> weights(fit.joint.unknowns.size());
    weights[fit.joint.indexOf({.kind = Unknown::Kind::CentreX, .arc = arc})] = perX;
    weights[fit.joint.indexOf({.kind = Unknown::Kind::CentreY, .arc = arc})] = perY;
    const double sigma = combined(budgetOf(fit.joint, weights, fit.noise.factor));
    return sigma * sigma;
  };
  const Intersection& found = *fit.intersection;
  return ellipseOf(variance(1, 0), variance(0, 1), (variance(1, 1) - variance(1, -1)) / 4,
                   ellipseFactor(found.coverage, found.effectiveDegreesOfFreedom));
}

std::optional<DrawnIntersection> drawnIntersection(const Measurement& measurement, const SessionFit& fit) {
  const ArcFit* upper = fit.arcAt(0);
  const ArcFit* lower = fit.arcAt(180);
  if (!fit.intersection || !upper || !lower) return {};
  const auto indexOf = [&](const ArcFit* arc) { return static_cast<std::size_t>(arc - fit.arcs.data()); };
  return DrawnIntersection{.upperCentre = {upper->circle.x, upper->circle.y},
                           .lowerCentre = {lower->circle.x, lower->circle.y},
                           .value = fit.intersection->value,
                           .expanded = fit.intersection->expanded,
                           .coverage = fit.intersection->coverage,
                           .upperEllipse = ellipseOfCentre(fit, indexOf(upper)),
                           .lowerEllipse = ellipseOfCentre(fit, indexOf(lower)),
                           .tolerance = measurement.tolerance};
}

}  // namespace

PlanePoint<double> DrawnEllipse::reach() const {
  const double cosine = std::cos(direction), sine = std::sin(direction);
  return {std::hypot(major * cosine, minor * sine), std::hypot(major * sine, minor * cosine)};
}

DrawnEllipse ellipseOf(double varianceX, double varianceY, double covariance, double scale) {
  const double mean = (varianceX + varianceY) / 2;
  const double spread = std::hypot((varianceX - varianceY) / 2, covariance);
  return {.major = scale * std::sqrt(std::max(mean + spread, 0.0)),
          .minor = scale * std::sqrt(std::max(mean - spread, 0.0)),
          .direction = std::atan2(2 * covariance, varianceX - varianceY) / 2};
}

double ellipseFactor(double coverage, double degreesOfFreedom) {
  // A point in a plane is outside the ellipse of k σ with probability (1 + k²/f)^(−f/2), by Fisher's F.
  if (std::isinf(degreesOfFreedom)) return std::sqrt(-2 * std::log1p(-coverage));
  return std::sqrt(degreesOfFreedom * std::expm1(-2 / degreesOfFreedom * std::log1p(-coverage)));
}

ArcPicture arcPicture(const Evaluation& evaluation) {
  ArcPicture picture;
  if (!evaluation.examined.measurement) return picture;
  const Measurement& measurement = *evaluation.examined.measurement;
  picture.sightings.reserve(measurement.rows);
  for (const ArcMeasurement& arc : measurement.arcs) {
    const std::size_t first = picture.sightings.size();
    for (const Sighting& sighting : arc.sightings) {
      picture.sightings.push_back(drawnSighting(measurement, arc, sighting));
    }
    if (const ArcFit* fit = evaluation.fit.arcOfPosition(arc.position)) {
      addAdjusted(picture, first, measurement, arc, *fit);
      if (fit == evaluation.fit.arcAt(arc.axisDeg)) picture.arcs.push_back(drawnArc(evaluation.fit, *fit));
    }
  }
  picture.excluded = excludedSightings(evaluation.session);
  picture.kinds = RowKinds::of(picture.sightings);
  for (const DrawnSighting& sighting : picture.excluded) picture.kinds.add(sighting.round, sighting.face);
  picture.intersection = drawnIntersection(measurement, evaluation.fit);
  picture.exaggeration = pickExaggeration(picture);
  return picture;
}

PlanePoint<double> ArcPicture::residualEnd(const DrawnSighting& sighting) const {
  if (!sighting.adjusted) return sighting.sighted;
  const PlanePoint<double>& foot = *sighting.adjusted;
  return {foot.x + exaggeration * sighting.residual.x, foot.y + exaggeration * sighting.residual.y};
}

QRectF ArcPicture::extent() const {
  double reach = 0;
  for (const DrawnArc& arc : arcs) reach = std::max(reach, 1.5 * arc.circle.radius);
  double left = 0, right = 0, bottom = 0, top = 0;
  const auto include = [&](double x, double y) {
    if (reach > 0 && std::max(std::abs(x), std::abs(y)) > 2 * reach) return;
    left = std::min(left, x), right = std::max(right, x);
    bottom = std::min(bottom, y), top = std::max(top, y);
  };
  for (const DrawnArc& arc : arcs) {
    constexpr int steps = 36;
    for (int i = 0; i <= steps; ++i) {
      const double angle = arc.firstAngle + (arc.lastAngle - arc.firstAngle) * i / steps;
      const auto [x, y] = targetOnArc(arc.circle.x, arc.circle.y, arc.circle.radius, angle);
      include(x, y);
    }
  }
  for (const DrawnSighting& sighting : sightings) {
    include(sighting.sighted.x, sighting.sighted.y);
    const PlanePoint<double> end = residualEnd(sighting);
    include(end.x, end.y);
  }
  for (const DrawnSighting& sighting : excluded) include(sighting.sighted.x, sighting.sighted.y);
  return QRectF(QPointF(left, bottom), QPointF(right, top));
}

std::shared_ptr<const ArcPicture> arcPictureOf(const Evaluation& evaluation) {
  return evaluation.pictures ? evaluation.pictures->arcs
                             : std::make_shared<const ArcPicture>(arcPicture(evaluation));
}

}  // namespace alidade::ui
