#include "core/diagnosis/diagnose.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/diagnosis/conclusion/afterwards.h"
#include "core/diagnosis/conclusion/causes.h"
#include "core/diagnosis/conclusion/known_checks.h"
#include "core/diagnosis/conclusion/location.h"
#include "core/diagnosis/conclusion/measured.h"
#include "core/diagnosis/conclusion/required.h"
#include "core/diagnosis/conclusion/unexplained.h"
#include "core/diagnosis/conclusion/with_forms.h"
#include "core/diagnosis/forms/session_forms.h"
#include "core/diagnosis/gap/gap_size.h"
#include "core/diagnosis/gap/held_out.h"
#include "core/diagnosis/observability/advice.h"
#include "core/diagnosis/observability/attainable.h"
#include "core/diagnosis/observability/undetectable.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"

namespace alidade {

namespace {

/// Returns the start model of the search without known sizes.
GapModel withoutKnown(const Inquiry& inquiry) {
  if (!isAnythingKnown(*inquiry.base.measurement)) return inquiry.base;
  return closedModelOf(inquiry.own).value_or(inquiry.own);
}

Shrinkage shrinkageOf(const Inquiry& inquiry, const Answer& answer) {
  const GapModel before = withoutKnown(inquiry.ofAll());
  Shrinkage shrink;
  const double rms = rmsOf(before), excess = excessOf(before);
  if (rms > 0) shrink.inSample = 1 - rmsOf(answer.after) / rms;
  if (excess > 0) shrink.ofExcess = std::clamp(1 - excessOf(answer.after) / excess, 0.0, 1.0);
  if (answer.kind == Answer::Kind::Several || !answer.explanation.parts.empty() ||
      !inquiry.excluded.empty() || isAnythingKnown(*inquiry.base.measurement))
    shrink.heldOut = heldOutShrinkage(before, answer.after);
  return shrink;
}

std::vector<GapShare> whereOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<GapShare> shares = sharesOfFrames(inquiry);
  std::ranges::move(sharesOfReadings(inquiry.ofAll().leftover, *inquiry.base.measurement, *answer.after.fit),
                    std::back_inserter(shares));
  std::ranges::move(sharesOfClosures(inquiry.ofAll().own), std::back_inserter(shares));
  return shares;
}

/// Returns the most likely pattern. Its share is p²/(p² + q²) with the lengths p of the pattern and q of the
/// rest. The share is at most 1, even if the pattern was found at another noise and exceeds the gap.
std::optional<GapShape> shapeOf(const Inquiry& inquiry) {
  const auto shaped = std::ranges::find_if(inquiry.explanations, &Explanation::shaped);
  if (shaped == inquiry.explanations.end()) return std::nullopt;
  const Part& pattern = shaped->parts.back();
  const Component& shape = inquiry.of(pattern);
  const Eigen::VectorXd taken = shape.signature(inquiry.leftover, pattern.weights);
  const double square = taken.squaredNorm(), left = (inquiry.leftover.residual() - taken).squaredNorm();
  return GapShape{std::string(shape.id()), square > 0 ? square / (square + left) : 0};
}

/// Returns the closure of the measured Δd against the reference. Absent without a measured Δd.
std::optional<Closure> againstReference(const Measurement& measurement,
                                        const std::optional<MeasuredIntersection>& measured) {
  if (!measured) return std::nullopt;
  const IntersectionEstimate& estimate = measured->estimate;
  return closureOf(Closure::Of::Reference, estimate.value - *measurement.referenceIntersection,
                   std::hypot(estimate.sigma, *measurement.sigmaReference), estimate.degreesOfFreedom);
}

std::vector<ClosureStep> closuresOf(const GapModel& own, const GapModel& opened,
                                    const std::optional<MeasuredIntersection>& measured) {
  const std::vector<Closure> then = everyClosureOf(opened);
  std::vector<ClosureStep> steps;
  for (const Closure& closure : everyClosureOf(own)) {
    steps.push_back({closure});
    if (closure.of == Closure::Of::Reference) {
      steps.back().after = againstReference(*own.measurement, measured);
      continue;
    }
    const auto same = std::ranges::find_if(then, [&](const Closure& other) {
      return other.of == closure.of && other.repeated == closure.repeated;
    });
    if (same != then.end()) steps.back().after = *same;
  }
  return steps;
}

std::optional<Closure> referenceIn(const std::vector<ClosureStep>& closures) {
  for (const ClosureStep& step : closures)
    if (step.before.of == Closure::Of::Reference) return step.after;
  return std::nullopt;
}

/// Returns the first cause that has look-alikes, and these look-alikes. Gross errors are skipped.
std::vector<PossibleCause> possibleCausesOf(const Inquiry& inquiry, const Answer& answer) {
  const auto possible = [&](const Part& part, double odds) {
    const Component& component = inquiry.of(part);
    return PossibleCause{std::string(component.id()), part.weights, odds, component.wrongZeroArc(),
                         component.jumpMoment()};
  };
  for (std::size_t p = 0; p < answer.rivals.size(); ++p) {
    const Part& part = answer.explanation.parts[p];
    if (std::ranges::all_of(answer.rivals[p], &Rival::isExcluded) || inquiry.of(part).grossErrorAt())
      continue;
    std::vector<PossibleCause> group{possible(part, 1)};
    for (const Rival& rival : answer.rivals[p])
      if (!rival.isExcluded) group.push_back(possible(rival.part, rival.odds));
    for (const Rival& other : otherWrongZeros(inquiry, answer.explanation, p))
      group.push_back(possible(other.part, other.odds));
    return group;
  }
  return {};
}

std::vector<ReadingDeviation> readingsOf(const GapModel& model) {
  std::vector<ReadingDeviation> readings;
  readings.reserve(model.fit->readings.size());
  for (const AdjustedReading& reading : model.fit->readings)
    readings.push_back(deviationAt(*model.measurement, {reading.arc, reading.sighting, reading.kind},
                                   Angle::fromRadians(reading.residual).arcseconds()));
  return readings;
}

/// Returns forms if no effect, or only inseparable effects, explain the gap. In the second case, forms must
/// beat the effects at three times their plausible size, and must resemble no effect.
FoundForms formsOf(const Inquiry& inquiry, const Answer& answer, const DiagnosisOptions& options,
                   const std::stop_token& stop) {
  constexpr EffectScales asPlausible, large{3, 3, 3};
  if (answer.kind == Answer::Kind::Unknown)
    return formsBeyond(inquiry, answer.explanation, asPlausible, options, stop);
  if (answer.kind != Answer::Kind::Several) return {};
  FoundForms found = formsBeyond(inquiry, answer.explanation, large, options, stop);
  const auto isOfCatalogue = [](const FoundForm& form) {
    return std::ranges::any_of(form.indistinguishableFrom,
                               [](const FormLookAlike& other) { return !other.effect.empty(); });
  };
  if (std::ranges::any_of(found.forms, isOfCatalogue)) return {};
  return found;
}

struct Conclusion {
  Inquiry inquiry;
  Answer answer;
  std::vector<FoundForm> forms;
  std::optional<GapShape> shape;  ///< with an Unknown answer
};

Conclusion concluded(Inquiry inquiry, const DiagnosisOptions& options, const std::stop_token& stop) {
  Answer answer = conclude(inquiry);
  std::optional<GapShape> shape;
  if (answer.kind == Answer::Kind::Unknown) shape = shapeOf(inquiry);
  FoundForms found;
  if (!options.forVerdict) found = formsOf(inquiry, answer, options, stop);
  takeUpForms(inquiry, answer, found);
  return {std::move(inquiry), std::move(answer), std::move(found.forms), std::move(shape)};
}

std::optional<IntersectionEstimate> afterwardsOf(const Conclusion& conclusion) {
  return hasForms(conclusion.inquiry, conclusion.answer)
             ? intersectionWithForms(conclusion.inquiry, conclusion.answer)
             : modelAveragedIntersection(conclusion.inquiry, conclusion.answer);
}

}  // namespace

Result<Diagnosis, DiagnosisFault> diagnose(const Measurement& measurement, const DiagnosisOptions& options,
                                           const std::stop_token& stop) {
  return diagnose(measurement, fitSession(measurement), options, stop);
}

Result<Diagnosis, DiagnosisFault> diagnose(const Measurement& measurement, const SessionFit& fit,
                                           const DiagnosisOptions& options, const std::stop_token& stop) {
  for (const std::string& id : options.without)
    if (!isDiagnosable(id, measurement)) return DiagnosisFault(UnknownCause{id});
  auto model = modelOf(measurement, fit);
  if (!model) return DiagnosisFault(model.problem());
  const DiagnosisFault stopped = Stopped{};
  if (stop.stop_requested()) return stopped;
  const bool heedsReference = options.withReference && measurement.sigmaReference;
  std::optional<IntersectionEstimate> found;
  std::optional<MeasuredWithEffects> measured;
  std::vector<Required> required;
  if (heedsReference) {
    DiagnosisOptions withoutReference = options;
    withoutReference.withReference = false;
    Inquiry plain = inquire(*model, withoutReference, stop);
    if (stop.stop_requested()) return stopped;
    if (const auto fault = undetermined(plain)) return DiagnosisFault(*fault);
    const Conclusion plainly = concluded(std::move(plain), withoutReference, stop);
    found = afterwardsOf(plainly);
    measured = measuredIntersection(plainly.inquiry, plainly.answer);
    required = whatItWouldTake(plainly.inquiry);
  }
  Inquiry inquired = inquire(*std::move(model), options, stop);
  if (stop.stop_requested()) return stopped;
  if (const auto fault = undetermined(inquired)) return DiagnosisFault(*fault);
  Conclusion conclusion = concluded(std::move(inquired), options, stop);
  const Inquiry& inquiry = conclusion.inquiry;
  const Answer& answer = conclusion.answer;
  if (stop.stop_requested()) return stopped;

  if (!heedsReference) {
    measured = measuredIntersection(inquiry, answer);
    if (!options.forVerdict) {
      found = afterwardsOf(conclusion);
      required = whatItWouldTake(inquiry);
    }
  }

  Diagnosis diagnosis;
  const GapModel& own = inquiry.ofAll().own;
  diagnosis.causes = causesOf(inquiry, answer);
  diagnosis.verdict = verdictOf(answer, diagnosis.causes);
  diagnosis.hasMoreCausesThanSeparable = answer.kind == Answer::Kind::Several;
  if (measured) diagnosis.measured = std::move(measured->intersection);
  diagnosis.closures = closuresOf(own, answer.opened, diagnosis.measured);
  diagnosis.unexplained = unexplainedOf(inquiry, answer, referenceIn(diagnosis.closures));
  const Eigen::VectorXd perReading = influencePerSigma(inquiry.base);
  diagnosis.undetectableJumps =
      undetectableJumps(inquiry.leftover, inquiry.candidates, perReading, *inquiry.base.measurement);
  if (options.forVerdict) return diagnosis;
  const double scatter = std::max(1.0, noiseScale(*answer.after.fit).factor);
  diagnosis.noise = answer.after.noise * scatter;
  diagnosis.gap = sizeOf(own);
  diagnosis.after = sizeOf(answer.opened);
  diagnosis.shrink = shrinkageOf(inquiry, answer);
  if (hasForms(inquiry, answer)) diagnosis.shrink.heldOut = conclusion.forms.front().shrink.heldOut;
  diagnosis.candidates = candidatesOf(inquiry.ofAll());
  diagnosis.known = knownChecks(inquiry, answer);
  diagnosis.where = whereOf(inquiry, answer);
  if (stop.stop_requested()) return stopped;
  diagnosis.steps = stepsOf(inquiry, answer);
  diagnosis.before = estimateOf(own);
  diagnosis.afterwards = found;
  const std::vector<Detectability> undetectable =
      undetectableEffects(inquiry.leftover, inquiry.candidates, perReading);
  for (const Detectability& detectability : undetectable)
    diagnosis.undetectable.push_back(
        {std::string(detectability.effect), detectability.influence, detectability.visible});
  diagnosis.shape = conclusion.shape;
  diagnosis.forms = std::move(conclusion.forms);
  diagnosis.whatItWouldTake = std::move(required);
  diagnosis.readings = readingsOf(own);
  if (stop.stop_requested()) return stopped;
  diagnosis.advice = adviceFor(inquiry, possibleCausesOf(inquiry, answer), diagnosis.causes, undetectable);
  if (stop.stop_requested()) return stopped;
  if (options.withAttainable && answer.kind != Answer::Kind::Unknown)
    diagnosis.attainable =
        attainableUncertainties(answer.after, scatter, measured ? measured->scales : EffectScales{});
  return diagnosis;
}

}  // namespace alidade
