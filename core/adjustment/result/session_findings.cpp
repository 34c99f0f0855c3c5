#include "core/adjustment/result/session_findings.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/quantity_text.h"
#include "core/base/statistics.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

bool holdsAxis(const Measurement& measurement, int axisDeg) {
  return std::ranges::any_of(measurement.arcs,
                             [&](const ArcMeasurement& arc) { return arc.axisDeg == axisDeg; });
}

/// One rigid guideway has one radius; L and its error are common to both arcs.
void judgeRadii(std::vector<Finding>& findings, const Measurement& measurement, const SessionFit& fit) {
  const ArcFit *upper = fit.arcAt(0), *lower = fit.arcAt(180);
  if (!upper || !lower || measurement.radiusModel != RadiusModel::Free) return;
  const double difference = upper->circle.radius - lower->circle.radius;
  std::vector<double> weights(fit.joint.unknowns.size());
  for (std::size_t arc = 0; arc < fit.arcs.size(); ++arc)
    weights[fit.joint.indexOf({.kind = Unknown::Kind::Radius, .arc = arc})] =
        &fit.arcs[arc] == upper ? 1 : -1;
  const double sigma = combined(budgetOf(fit.joint, weights, fit.noise.factor));
  constexpr double risk = 0.001;
  constexpr double leastFactor =
      3.29;  // the normal distribution's; a quantile takes longer than all the rest
  if (std::abs(difference) <= leastFactor * sigma) return;
  const double bound = coverageFactor(1 - risk, fit.noise.degreesOfFreedom) * sigma;
  if (std::abs(difference) <= bound) return;
  findings.push_back({Severity::Warning,
                      "The radii at 0° and 180° differ by " + displayText(std::abs(difference), 3) +
                          " mm, more than their noise allows (" + displayText(bound, 3) +
                          " mm at 0.1 % risk), though the guideway is one rigid arc.",
                      "Look for a cause outside the model, such as a plane off the rotation axis, before "
                      "trusting the intersection.",
                      {}});
}

/// The readings tell the radius, too. What they say apart from R0 differs from the fitted radius as R0 does,
/// in proportion to the weights: R0 − R has the variance σ0² − σ_R² where both agree with their σ.
void judgeKnownRadius(std::vector<Finding>& findings, const Measurement& measurement, const SessionFit& fit) {
  if (measurement.radiusModel != RadiusModel::Known || fit.arcs.empty()) return;
  const double prior = fit.joint.radiusPriorSigma;
  const std::size_t radius = fit.joint.indexOf({.kind = Unknown::Kind::Radius});
  std::vector<double> weights(fit.joint.unknowns.size());
  weights[radius] = 1;
  const double variance = fit.joint.cofactor(radius, radius);
  const double ofReadings =
      std::pow(fit.noise.factor, 2) * (variance - variance * variance / (prior * prior));
  const double ofRadius = std::pow(prior - variance / prior, 2);
  double ofConsidered = 0;
  for (const BudgetEntry& entry : budgetOf(fit.joint, weights, fit.noise.factor))
    if (entry.source == "pointing zeros" || entry.source == "distance")
      ofConsidered += std::pow(entry.sigma, 2);
  const double away = fit.joint.values[radius] - measurement.nominalRadius;
  constexpr double risk = 0.001;
  const double bound = coverageFactor(1 - risk, fit.noise.degreesOfFreedom) *
                       std::sqrt(std::max(0.0, ofReadings + ofRadius + ofConsidered));
  if (std::abs(away) <= bound) return;
  findings.push_back({Severity::Warning,
                      "The readings do not agree with the known radius of " +
                          displayShortest(measurement.nominalRadius) + " mm: they pull it by " +
                          displayText(away, 4) + " mm, where " + displayText(bound, 4) +
                          " mm is the most that their noise and its σ allow at 0.1 % risk.",
                      "Check R0, its σ and the distance, or let the radius be free.",
                      Place{.position = {}, .reading = {}, .field = "geometry.radius_mm"}});
}

void judgeReference(std::vector<Finding>& findings, const Measurement& measurement, const SessionFit& fit) {
  if (!fit.intersection || !measurement.referenceIntersection) return;
  const double difference = fit.intersection->value - *measurement.referenceIntersection;
  if (std::abs(difference) <= fit.intersection->expanded) return;
  findings.push_back({Severity::Warning,
                      "The intersection differs from the reference " +
                          displayShortest(*measurement.referenceIntersection) + " mm by " +
                          displayText(difference, 3) + " mm, more than its expanded uncertainty of " +
                          displayText(fit.intersection->expanded, 3) + " mm.",
                      "Nothing was fitted to the reference; find what separates the two.",
                      Place{.position = {}, .reading = {}, .field = "acceptance.reference_intersection_mm"}});
}

}  // namespace

std::vector<Finding> missingPositions(const Measurement& measurement) {
  std::vector<Finding> findings;
  for (const int axisDeg : {0, 180})
    if (!holdsAxis(measurement, axisDeg))
      findings.push_back(
          {Severity::Warning,
           "There is no usable position at " + std::to_string(axisDeg) + "°, so no intersection.",
           "The intersection is half the distance of the arc centres at 0° and 180°: measure both.",
           {}});
  return findings;
}

std::vector<Finding> modelFindings(const Measurement& measurement) {
  std::vector<Finding> findings;
  for (const std::string& id : measurement.effects)
    if (!effectById(id))
      findings.push_back(
          {Severity::Warning,
           "The session's model names " + quotation(id) + ", which is no effect that can be estimated.",
           "Read the result as one without it, or correct the name.",
           Place{.position = {}, .reading = {}, .field = "model.effects"}});
  if (measurement.relation == VerticalAngleRelation::Planar)
    findings.push_back({Severity::Warning,
                        "The model takes the vertical circle to read y/L, which no theodolite does.",
                        "Set the vertical angle to exact, unless the planar relation is to be studied.",
                        Place{.position = {}, .reading = {}, .field = "model.vertical_angle"}});
  return findings;
}

std::vector<Finding> sessionFindings(const Measurement& measurement, const SessionFit& fit) {
  std::vector<Finding> findings = missingPositions(measurement);
  judgeRadii(findings, measurement, fit);
  judgeKnownRadius(findings, measurement, fit);
  judgeReference(findings, measurement, fit);
  std::ranges::move(modelFindings(measurement), std::back_inserter(findings));
  return findings;
}

}  // namespace alidade
