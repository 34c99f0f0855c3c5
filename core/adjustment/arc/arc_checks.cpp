#include "core/adjustment/arc/arc_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alidade {

namespace {

/// Two places closer than this many σ of a sighted point may be the same place.
constexpr double samePlaceSigmas = 5;
constexpr double largestRadiusUncertainty = 1.0 / 3;

std::size_t countDifferent(const std::vector<PlanePoint<double>>& places, double resolution,
                           std::size_t enough) {
  std::vector<PlanePoint<double>> different;
  for (const auto& place : places) {
    const bool known = std::ranges::any_of(different, [&](const auto& other) {
      return std::hypot(place.x - other.x, place.y - other.y) <= resolution;
    });
    if (!known) different.push_back(place);
    if (different.size() == enough) break;
  }
  return different.size();
}

}  // namespace

std::optional<ArcFault> tooFewPlaces(const Measurement& measurement,
                                     const std::vector<PlanePoint<double>>& places) {
  constexpr std::size_t needed = 3;
  if (places.size() < needed) return arc_fault::TooFewPlaces{places.size()};
  const double sigma = std::max(measurement.sigmaHorizontal, measurement.sigmaVertical).radians();
  const std::size_t different =
      countDifferent(places, samePlaceSigmas * sigma * measurement.distance, needed);
  if (different < needed) return arc_fault::PlacesRepeat{different};
  return std::nullopt;
}

std::optional<ArcFault> radiusUndetermined(const ArcFit& fit) {
  const double sigma = std::sqrt(fit.cofactor[2][2]);
  if (std::isfinite(sigma) && sigma <= largestRadiusUncertainty * fit.circle.radius) return std::nullopt;
  constexpr double wide = 60;  // the sagitta is a seventh of the radius: too much for a theodolite's noise
  const Angle span = arcSpan(fit);
  if (span.degrees() < wide) return arc_fault::ArcTooShort{span};
  return arc_fault::NothingTold{};
}

Angle arcSpan(const ArcFit& fit) {
  std::vector<double> angles;
  for (const auto& residual : fit.residuals) angles.push_back(residual.arcAngle);
  if (angles.size() < 2) return {};
  std::ranges::sort(angles);
  // The widest gap is the part of the circle that was not sighted.
  double widestGap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widestGap = std::max(widestGap, angles[i] - angles[i - 1]);
  return Angle::fromRadians(2 * std::numbers::pi - widestGap);
}

}  // namespace alidade
