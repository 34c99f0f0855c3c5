#include "core/adjustment/arc/arc_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alidade {

namespace {

/// Two places closer than this many σ of a sighted point may be the same place.
constexpr double samePlaceSigmas = 5;
constexpr double largestRadiusUncertainty = 1.0 / 3;

}  // namespace

DifferentPlaces::DifferentPlaces(const Measurement& measurement)
    : m_resolution(samePlaceSigmas *
                   std::max(measurement.sigmaHorizontal, measurement.sigmaVertical).radians() *
                   measurement.distance) {}

bool DifferentPlaces::areEnoughWith(const PlanePoint<double>& place) {
  if (m_places.size() == needed) return true;
  const bool isKnown = std::ranges::any_of(m_places, [&](const PlanePoint<double>& other) {
    return std::hypot(place.x - other.x, place.y - other.y) <= m_resolution;
  });
  if (!isKnown) m_places.push_back(place);
  return m_places.size() == needed;
}

std::optional<ArcFault> tooFewPlaces(const Measurement& measurement,
                                     const std::vector<PlanePoint<double>>& places) {
  if (places.size() < DifferentPlaces::needed) return arc_fault::TooFewPlaces{places.size()};
  DifferentPlaces different(measurement);
  for (const PlanePoint<double>& place : places)
    if (different.areEnoughWith(place)) return std::nullopt;
  return arc_fault::PlacesRepeat{different.count()};
}

std::optional<ArcFault> radiusUndetermined(const ArcFit& fit) {
  const double sigma = std::sqrt(fit.cofactor[2][2]);
  if (std::isfinite(sigma) && sigma <= largestRadiusUncertainty * fit.circle.radius) return std::nullopt;
  constexpr double wide = 60;  // degrees; the sagitta is then R/7, far above a theodolite's noise
  const Angle span = arcSpan(fit);
  if (span.degrees() < wide) return arc_fault::ArcTooShort{span};
  return arc_fault::RadiusUndetermined{};
}

Angle arcSpan(const ArcFit& fit) {
  std::vector<double> angles;
  for (const auto& residual : fit.residuals) angles.push_back(residual.arcAngle);
  if (angles.size() < 2) return {};
  std::ranges::sort(angles);
  // The widest gap between sightings is the part of the circle outside the arc.
  double widestGap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widestGap = std::max(widestGap, angles[i] - angles[i - 1]);
  return Angle::fromRadians(2 * std::numbers::pi - widestGap);
}

}  // namespace alidade
