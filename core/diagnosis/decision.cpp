#include "core/diagnosis/decision.h"

#include "core/diagnosis/conformance.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// Undecided where the causes leave the measurand undetermined. Of a part alone no more can be said than that
/// it is too long.
Verdict verdictOf(const std::optional<MeasuredIntersection>& measured, const Measurement& measurement) {
  if (!measured) return Verdict::Undecided;
  const auto decided = [&](const auto& length) {
    return decide(length.value, length.expanded, *measurement.tolerance);
  };
  const Verdict inPlane = decided(measured->estimate);
  if (measurement.measurand == Measurand::Intersection) return inPlane;
  if (measured->distance) return decided(*measured->distance);
  return inPlane == Verdict::Reject ? inPlane : Verdict::Undecided;
}

/// Of a distance the fit knows a part, which may be short enough where the whole is not.
bool contradict(const AcceptanceDecision& decision, Measurand measurand) {
  if (measurand == Measurand::Distance)
    return decision.asFound == Verdict::Accept && decision.asModelled != Verdict::Accept;
  return decision.asFound.value_or(decision.asModelled) != decision.asModelled;
}

/// A part of the distance is neither measured nor too long by itself.
bool isAcrossMissing(const AcceptanceDecision& decision, Measurand measurand, const Diagnosis* diagnosis) {
  const bool isMeasured = diagnosis && diagnosis->measured && diagnosis->measured->across;
  return measurand == Measurand::Distance && !isMeasured &&
         decision.asFound.value_or(decision.asModelled) != Verdict::Reject;
}

std::optional<double> conformanceOf(const Measurement& measurement, const SessionFit& fit,
                                    const Diagnosis* diagnosis) {
  const double tolerance = *measurement.tolerance;
  if (!diagnosis) return conformanceOf(estimateOf(*fit.intersection), tolerance);
  if (!diagnosis->measured) return std::nullopt;
  const MeasuredIntersection& measured = *diagnosis->measured;
  return measurement.measurand == Measurand::Distance && measured.across
             ? conformanceOf(measured.estimate, *measured.across, tolerance)
             : conformanceOf(measured.estimate, tolerance);
}

}  // namespace

bool isMoreThanNoise(const Diagnosis& diagnosis) {
  if (diagnosis.verdict == DiagnosisVerdict::WithinNoise) return false;
  return diagnosis.causes.size() != 1 || diagnosis.causes.front().effect != noiseId;
}

std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis) {
  if (!fit.verdict) return std::nullopt;
  AcceptanceDecision decision{.asModelled = *fit.verdict};
  if (diagnosis) decision.asFound = verdictOf(diagnosis->measured, measurement);
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
  if (diagnosis && isMisclosed(*diagnosis)) {
    decision.verdict = Verdict::Undecided;
    if (decision.obstacle != AcceptanceDecision::Obstacle::Contradiction)
      decision.obstacle = AcceptanceDecision::Obstacle::Misclosure;
    return decision;
  }
  if (decision.obstacle != AcceptanceDecision::Obstacle::AcrossUnknown)
    decision.conformance = conformanceOf(measurement, fit, diagnosis);
  return decision;
}

}  // namespace alidade
