#include "core/adjustment/arc/arc_findings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/quantity_text.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

/// Two places closer than this many σ of a sighted point may be the same place.
constexpr double samePlaceSigmas = 5;
/// A chance this small is taken for a sign that the stated noise is wrong.
constexpr double surprise = 0.001;
constexpr double largestRadiusUncertainty = 1.0 / 3;
constexpr double poorRadiusUncertainty = 0.01;
constexpr double farFromNominal = 0.05;

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

void add(std::vector<Finding>& findings, const ArcFit& fit, Severity severity, std::string text,
         std::string remedy) {
  findings.push_back({severity, std::to_string(fit.axisDeg) + "°: " + std::move(text), std::move(remedy),
                      Place{.position = fit.position, .reading = {}, .field = "readings"}});
}

void judgeRedundancyAndNoise(std::vector<Finding>& findings, const ArcFit& fit) {
  if (fit.degreesOfFreedom <= 0) {
    add(findings, fit, Severity::Warning,
        "the readings just fix the circle; nothing checks them, and the uncertainty rests on the stated "
        "noise alone.",
        "Sight more places.");
    return;
  }
  const std::optional<double> tail = chiSquareUpperTail(fit.chiSquare, fit.degreesOfFreedom);
  if (!tail) return;
  const double upper = *tail;
  const std::string numbers = "(reduced χ² " + displayText(fit.reducedChiSquare(), 2) + " with " +
                              std::to_string(fit.degreesOfFreedom) + " degrees of freedom)";
  if (upper < surprise)
    add(findings, fit, Severity::Warning,
        "the readings scatter " + displayText(std::sqrt(fit.reducedChiSquare()), 1) +
            " times their stated noise " + numbers + ".",
        "Look for misread values or an effect that the model does not hold; the uncertainty of the readings "
        "is "
        "scaled up by the scatter.");
  else if (1 - upper < surprise)
    add(findings, fit, Severity::Note,
        "the readings agree far better than their stated noise " + numbers + ".",
        "Check the stated σ, and that the readings were not copied from one another.");
}

void judgeRadius(std::vector<Finding>& findings, const Measurement& measurement, const ArcFit& fit) {
  const double sigma = fit.radiusSigma();
  if (sigma > poorRadiusUncertainty * fit.circle.radius)
    add(findings, fit, Severity::Warning,
        "an arc of " + displayText(arcSpan(fit).degrees(), 1) + "° fixes the radius to ± " +
            displayText(sigma, 1) + " mm only (1σ), and the centre hardly better.",
        "Sight places over a longer arc.");
  const double difference = fit.circle.radius - measurement.nominalRadius;
  if (std::abs(difference) > farFromNominal * measurement.nominalRadius + 3 * sigma)
    add(findings, fit, Severity::Warning,
        "the fitted radius " + displayText(fit.circle.radius, 1) + " mm is far from the nominal " +
            displayText(measurement.nominalRadius, 1) + " mm.",
        "Check the distance L and the nominal radius R0: the fitted lengths are proportional to L.");
}

void judgeRepeats(std::vector<Finding>& findings, const ArcMeasurement& arc, const ArcFit& fit) {
  std::vector<std::size_t> order(arc.sightings.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) {
    const Sighting& s = arc.sightings[i];
    return std::tuple(s.face, s.a, s.e, i);
  };
  std::ranges::sort(order, [&](std::size_t l, std::size_t r) { return key(l) < key(r); });

  std::string rows;
  int repeats = 0;
  constexpr int named = 3;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Sighting &first = arc.sightings[order[k - 1]], &second = arc.sightings[order[k]];
    if (first.face != second.face || first.a != second.a || first.e != second.e) continue;
    if (++repeats <= named)
      rows += (rows.empty() ? "" : ", ") + std::to_string(first.row + 1) + " and " +
              std::to_string(second.row + 1);
  }
  if (repeats == 0) return;
  if (repeats > named) rows += ", …";
  add(findings, fit, Severity::Warning, "the same pair of readings stands twice, in rows " + rows + ".",
      "If a row was entered twice, exclude one: a copy makes the result look surer than it is.");
}

}  // namespace

std::optional<std::string> tooFewPlaces(const Measurement& measurement,
                                        const std::vector<PlanePoint<double>>& places) {
  constexpr std::size_t needed = 3;
  if (places.size() < needed)
    return "has readings of " + counted(places.size(), "place") +
           "; a circle needs three, and five or more for a check: sight more places";
  const double sigma = std::max(measurement.sigmaHorizontal, measurement.sigmaVertical).radians();
  const std::size_t different =
      countDifferent(places, samePlaceSigmas * sigma * measurement.distance, needed);
  if (different < needed)
    return "has readings of only " + std::to_string(different) + " different " +
           (different == 1 ? "place" : "places") +
           ", the others repeat them; a circle needs three: move the slider between the points";
  return std::nullopt;
}

std::string straightLineSentence() {
  return "has readings that lie on a straight line, which fixes no circle: check them, and sight places over "
         "a longer "
         "arc";
}

std::optional<std::string> radiusUndetermined(const ArcFit& fit) {
  const double sigma = std::sqrt(fit.cofactor[2][2]);
  if (std::isfinite(sigma) && sigma <= largestRadiusUncertainty * fit.circle.radius) return std::nullopt;
  constexpr double wide = 60;  // the sagitta is a seventh of the radius: too much for a theodolite's noise
  const double span = arcSpan(fit).degrees();
  if (!(span < wide))
    return "has readings that tell neither radius nor centre: look for misread values, the degrees first, "
           "and check the stated σ of the circles";
  return "spans only " + displayText(span, 2) +
         "° of arc: its sagitta drowns in the reading noise, so neither radius nor centre can be told: sight "
         "places over "
         "a longer arc";
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

std::vector<Finding> arcFindings(const Measurement& measurement, const ArcMeasurement& arc,
                                 const ArcFit& fit) {
  std::vector<Finding> findings;
  if (!fit.converged())
    add(findings, fit, Severity::Warning,
        "the fit did not settle within " + std::to_string(fit.iterations) +
            " iterations; its result is provisional.",
        "Check the readings for large errors.");
  judgeRedundancyAndNoise(findings, fit);
  judgeRadius(findings, measurement, fit);
  judgeRepeats(findings, arc, fit);
  return findings;
}

}  // namespace alidade
