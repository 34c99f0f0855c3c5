#include "core/diagnosis/decision.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/conformance.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// `more` is a further standard uncertainty, mm.
Verdict verdictOf(const IntersectionEstimate& estimate, double more, const Measurement& measurement) {
  const double tolerance = *measurement.tolerance, risk = (1 - measurement.coverage) / 2;
  const Verdict guarded = decide(estimate.value, estimate.expanded, tolerance);
  if (guarded == Verdict::Undecided || (estimate.explanations.size() < 2 && !(more > 0))) return guarded;
  const std::optional<TailRisk> beyond = tailRiskOf(widened(estimate, more), tolerance);
  if (!beyond) return Verdict::Undecided;
  const bool holds = guarded == Verdict::Accept ? beyond->areAtMost(risk)
                                                : std::max(beyond->above, beyond->below) >= 1 - risk;
  return holds ? guarded : Verdict::Undecided;
}

/// The verdict from Δd, measured. Undecided if the readings do not determine the measurand. If the distance
/// is the measurand and only Δd is measured, Δd can only cause a rejection.
Verdict verdictOf(const std::optional<MeasuredIntersection>& measured, double more,
                  const Measurement& measurement) {
  if (!measured) return Verdict::Undecided;
  const Verdict inPlane = verdictOf(measured->estimate, more, measurement);
  if (measurement.measurand == Measurand::Intersection) return inPlane;
  if (measured->distance) {
    const MeasuredLength& distance = *measured->distance;
    const double wider = std::hypot(distance.sigma, more) / distance.sigma;
    return decide(distance.value, wider * distance.expanded, *measurement.tolerance);
  }
  return inPlane == Verdict::Reject ? inPlane : Verdict::Undecided;
}

/// Whether the results of fit only and measured contradict each other. If the distance is the measurand, the
/// fit determines only a part of it, which may be within the tolerance although the whole distance is not.
bool contradict(const AcceptanceDecision& decision, Measurand measurand) {
  if (measurand == Measurand::Distance)
    return decision.asFound == Verdict::Accept && decision.asModelled != Verdict::Accept;
  return decision.asFound.value_or(decision.asModelled) != decision.asModelled;
}

/// Whether an unmeasured part of the distance leaves the verdict open: the rest alone causes no rejection.
bool isAcrossMissing(const AcceptanceDecision& decision, Measurand measurand, const Diagnosis* diagnosis) {
  const bool isMeasured = diagnosis && diagnosis->measured && diagnosis->measured->across;
  return measurand == Measurand::Distance && !isMeasured &&
         decision.asFound.value_or(decision.asModelled) != Verdict::Reject;
}

/// `more` is a further standard uncertainty, mm.
std::optional<double> conformanceWith(double more, const MeasuredIntersection& measured,
                                      const Measurement& measurement) {
  const IntersectionEstimate estimate = widened(measured.estimate, more);
  return measurement.measurand == Measurand::Distance && measured.across
             ? conformanceOf(estimate, *measured.across, *measurement.tolerance)
             : conformanceOf(estimate, *measurement.tolerance);
}

std::optional<double> conformanceOf(const Measurement& measurement, const SessionFit& fit,
                                    const Diagnosis* diagnosis) {
  if (!diagnosis) return conformanceOf(estimateOf(*fit.intersection), *measurement.tolerance);
  if (!diagnosis->measured) return std::nullopt;
  const double more = diagnosis->unexplained.sigma;
  auto conformance = conformanceWith(more, *diagnosis->measured, measurement);
  if (!conformance) return conformance;
  double odds = 1;  // relative to sessions without undetectable jumps
  for (const UndetectableJump& jump : diagnosis->undetectableJumps)
    for (const NormalPart& move : jump.moves) {
      const auto with = conformanceWith(std::hypot(more, move.sigma), *diagnosis->measured, measurement);
      *conformance += move.share * with.value_or(0);
      odds += move.share;
    }
  return *conformance / odds;
}

/// Returns the jumps whose influence, added to the standard uncertainty of Δd, changes the verdict.
std::vector<std::size_t> conditionsOf(const Measurement& measurement, const Diagnosis& diagnosis,
                                      Verdict verdict) {
  std::vector<std::size_t> conditions;
  if (verdict == Verdict::Undecided) return conditions;
  for (std::size_t i = 0; i < diagnosis.undetectableJumps.size(); ++i) {
    const double more = std::hypot(diagnosis.unexplained.sigma, diagnosis.undetectableJumps[i].influence);
    if (verdictOf(diagnosis.measured, more, measurement) != verdict) conditions.push_back(i);
  }
  return conditions;
}

}  // namespace

bool hasGap(const Diagnosis& diagnosis) {
  return diagnosis.verdict != DiagnosisVerdict::WithinNoise || isMisclosed(diagnosis);
}

bool isMoreThanNoise(const Diagnosis& diagnosis) {
  if (diagnosis.verdict == DiagnosisVerdict::WithinNoise) return false;
  return diagnosis.causes.size() != 1 || diagnosis.causes.front().effect != noiseId;
}

const MeasuredLength* judgedDistance(const Measurement& measurement, const MeasuredIntersection& measured) {
  return measurement.measurand == Measurand::Distance && measured.distance ? &*measured.distance : nullptr;
}

bool isUnexplained(const Diagnosis& diagnosis) {
  return diagnosis.unexplained.chance > thresholds.mostUnexplained;
}

std::optional<AcceptanceDecision> decideVerdict(const Measurement& measurement, const SessionFit& fit,
                                                const Diagnosis* diagnosis) {
  if (!fit.verdict) return std::nullopt;
  AcceptanceDecision decision{.asModelled = *fit.verdict};
  if (diagnosis) decision.asFound = verdictOf(diagnosis->measured, diagnosis->unexplained.sigma, measurement);
  decision.showsBoth = diagnosis != nullptr;
  if (fit.lengthsInDoubt) {
    decision.obstacle = AcceptanceDecision::Obstacle::Lengths;
    return decision;
  }
  if (measurement.coverage < leastCoverageOfVerdict) {
    decision.obstacle = AcceptanceDecision::Obstacle::Coverage;
    return decision;
  }
  if (isAcrossMissing(decision, measurement.measurand, diagnosis)) {
    decision.obstacle = AcceptanceDecision::Obstacle::AcrossUnknown;
  } else if (contradict(decision, measurement.measurand)) {
    decision.obstacle = AcceptanceDecision::Obstacle::Contradiction;
  } else {
    decision.verdict = decision.asFound.value_or(decision.asModelled);
    if (decision.verdict != Verdict::Undecided) decision.obstacle = AcceptanceDecision::Obstacle::None;
  }
  if (diagnosis && isUnexplained(*diagnosis)) {
    decision.verdict = Verdict::Undecided;
    if (decision.obstacle != AcceptanceDecision::Obstacle::Contradiction)
      decision.obstacle = AcceptanceDecision::Obstacle::Unexplained;
  }
  return decision;
}

std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis) {
  using enum AcceptanceDecision::Obstacle;
  std::optional<AcceptanceDecision> decision = decideVerdict(measurement, fit, diagnosis);
  if (!decision || decision->obstacle == Lengths || decision->obstacle == Coverage ||
      (diagnosis && isUnexplained(*diagnosis)))
    return decision;
  if (diagnosis) decision->conditions = conditionsOf(measurement, *diagnosis, decision->verdict);
  if (decision->obstacle != AcrossUnknown) decision->conformance = conformanceOf(measurement, fit, diagnosis);
  return decision;
}

}  // namespace alidade
