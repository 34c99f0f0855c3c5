#include "core/diagnosis/decision.h"

#include <algorithm>

#include "core/base/statistics.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// Of Δd + `shift` within the tolerance. Absent without degrees of freedom or an uncertainty.
std::optional<double> conformanceOf(const IntersectionEstimate& estimate, double tolerance,
                                    double shift = 0) {
  double within = 0, all = 0;
  for (const NormalPart& account : estimate.accounts) {
    const auto below = [&](double limit) {
      return studentLowerTail((limit - shift - account.mean) / account.sigma, estimate.degreesOfFreedom);
    };
    const std::optional<double> high = below(tolerance), low = below(-tolerance);
    if (!high || !low) return std::nullopt;
    within += account.share * (*high - *low);
    all += account.share;
  }
  if (!(all > 0)) return std::nullopt;
  return within / all;
}

std::optional<IntersectionEstimate> estimateOf(const std::optional<MeasuredIntersection>& measured) {
  return measured ? std::optional(measured->estimate) : std::nullopt;
}

/// Undecided where the causes leave Δd undetermined.
Verdict verdictOf(const std::optional<IntersectionEstimate>& found, double tolerance) {
  return found ? decide(found->value, found->expanded, tolerance) : Verdict::Undecided;
}

}  // namespace

std::optional<double> greatestRisk(const IntersectionEstimate& estimate, double tolerance) {
  double greatest = 0;
  const auto within = [&](double edge) { return conformanceOf(estimate, tolerance, edge - estimate.value); };
  for (const double side : {-1.0, 1.0}) {
    const auto accepted = within(side * (tolerance - estimate.expanded)),
               rejected = within(side * (tolerance + estimate.expanded));
    if (!accepted || !rejected) return std::nullopt;
    if (estimate.expanded <= tolerance) greatest = std::max(greatest, 1 - *accepted);
    greatest = std::max(greatest, *rejected);
  }
  return greatest;
}

bool isMoreThanNoise(const Diagnosis& diagnosis) {
  if (diagnosis.verdict == DiagnosisVerdict::WithinNoise) return false;
  return diagnosis.causes.size() != 1 || diagnosis.causes.front().effect != noiseId;
}

std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis) {
  if (!fit.verdict) return std::nullopt;
  AcceptanceDecision decision{.asModelled = *fit.verdict};
  const double tolerance = *measurement.tolerance;
  if (diagnosis) decision.asFound = verdictOf(estimateOf(diagnosis->measured), tolerance);
  decision.showsBoth = diagnosis != nullptr;
  if (fit.lengthsInDoubt) {
    decision.obstacle = AcceptanceDecision::Obstacle::Lengths;
    return decision;
  }
  if (measurement.coverage < leastCoverageOfVerdict) {
    decision.obstacle = AcceptanceDecision::Obstacle::Coverage;
    return decision;
  }
  if (decision.asFound.value_or(decision.asModelled) != decision.asModelled) {
    decision.obstacle = AcceptanceDecision::Obstacle::Contradiction;
  } else {
    decision.verdict = decision.asModelled;
    if (decision.verdict != Verdict::Undecided) decision.obstacle = AcceptanceDecision::Obstacle::None;
  }
  if (diagnosis && isMisclosed(*diagnosis)) {
    decision.verdict = Verdict::Undecided;
    if (decision.obstacle != AcceptanceDecision::Obstacle::Contradiction)
      decision.obstacle = AcceptanceDecision::Obstacle::Misclosure;
    return decision;
  }
  if (!diagnosis)
    decision.conformance = conformanceOf(estimateOf(*fit.intersection), tolerance);
  else if (diagnosis->measured)
    decision.conformance = conformanceOf(diagnosis->measured->estimate, tolerance);
  return decision;
}

}  // namespace alidade
