#include "core/statement/headline_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"
#include "core/wording/closures.h"
#include "core/wording/conditions.h"
#include "core/wording/effect_name.h"
#include "core/wording/size_text.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

using Line = Headline::Line;

/// A value that is judged, Δd or the distance from the axis, and its U, mm.
struct Judged {
  double value, expanded;
};

/// "The interval from 0.21 to 0.59 mm crosses the limit of 0.5 mm"; empty if the interval does not cross the
/// limit, or if U is too large to determine the value.
std::string crossing(const Judged& judged, const Measurement& measurement, const char* text) {
  const auto [value, expanded] = judged;
  const double size = std::abs(value), tolerance = *measurement.tolerance;
  const bool isAcross = size - expanded <= tolerance && size + expanded > tolerance;
  if (!isAcross || !isDetermined(measurement, expanded)) return "";
  const int decimals = decimalsToDecide(value, expanded, tolerance);
  const auto [low, high] = endsAsWritten(value, expanded, decimals);
  return Phrase::of(text, displayText(low, decimals), displayText(high, decimals),
                    displayShortest(value < 0 ? -tolerance : tolerance));
}

/// The sentence on the interval that crosses the limit and so keeps the verdict open; may be empty.
std::string intervalText(const Measurement& measurement, const SessionFit& fit,
                         const IntersectionEstimate& found, const MeasuredIntersection* measured,
                         const AcceptanceDecision* decision) {
  using enum AcceptanceDecision::Obstacle;
  if (!decision || decision->verdict != Verdict::Undecided) return "";
  if (decision->obstacle == Lengths || decision->obstacle == Coverage) return "";
  if (measured && !isDetermined(measurement, measured->estimate.expanded)) return "";
  const MeasuredLength* distance = measured ? judgedDistance(measurement, *measured) : nullptr;
  const std::string own = crossing(
      distance ? Judged{distance->value, distance->expanded} : Judged{found.value, found.expanded},
      measurement, PHRASE_LATER("Phrase", "The interval from %1 to %2 mm crosses the limit of %3 mm"));
  if (!own.empty() || distance) return own;
  return crossing(
      {fit.intersection->value, fit.intersection->expanded}, measurement,
      PHRASE_LATER("Phrase", "The interval of the fit only, from %1 to %2 mm, crosses the limit of %3 mm"));
}

/// The line on Δz, to which a tolerance of Δd does not apply. For a tolerance of the distance from the axis,
/// the line on both its parts.
Line acrossLine(const Measurement& measurement, const MeasuredIntersection& measured) {
  const bool isOfDistance = measurement.measurand == Measurand::Distance;
  const IntersectionEstimate& inPlane = measured.estimate;
  if (!measured.across)
    return {.kind = Line::Kind::Across,
            .text = Phrase::of("Across the plane of the arc: Δz was not measured"),
            .isWarning = isOfDistance};
  const std::string across = sizeWithExpanded(measured.across->value, measured.across->expanded, "mm");
  if (isOfDistance)
    return {.kind = Line::Kind::Across,
            .text = Phrase::of("In the plane of the arc Δd = %1, perpendicular to it Δz = %2",
                               sizeWithExpanded(inPlane.value, inPlane.expanded, "mm"), across)};
  return {
      .kind = Line::Kind::Across,
      .text = measurement.tolerance
                  ? Phrase::of("Across the plane of the arc: Δz = %1, not judged (the tolerance is of Δd)",
                               across)
                  : Phrase::of("Across the plane of the arc: Δz = %1", across),
      .isWarning = isAcrossSignificant(measured)};
}

/// Whether the verdict is accept or reject. If so, the causes are its condition.
bool isReached(const AcceptanceDecision* decision) {
  return decision && decision->verdict != Verdict::Undecided;
}

std::string withDetails(const std::string& text, const std::string& details) {
  //: a sentence and what it rests on: "… (72 %): the radii differ by 13 σ"
  return details.empty() ? text : Phrase::of("%1: %2", text, details);
}

std::string disagreementText(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case DiagnosisVerdict::WithinNoise:
      return Phrase::of("The positions do not agree");
    case DiagnosisVerdict::NotInCatalogue:
      return Phrase::of("Model and readings disagree, and no catalogued effect explains it");
    case DiagnosisVerdict::SeveralCauses:
      return Phrase::of(
          "Model and readings disagree because of more causes than these readings can separate");
    case DiagnosisVerdict::SingleCause:
    case DiagnosisVerdict::Ambiguous:
      break;
  }
  return Phrase::of("The readings scatter more than stated; U includes this");
}

bool isFound(const Diagnosis& diagnosis, const std::string& effect) {
  return std::ranges::find(diagnosis.causes, effect, &Cause::effect) != diagnosis.causes.end();
}

/// The look-alikes of the only cause besides noise; empty if there is no such cause or more than one.
std::vector<std::string> lookAlikes(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  const Cause* only = nullptr;
  for (const Cause& cause : diagnosis.causes) {
    if (cause.effect == noiseId) continue;
    if (only) return {};
    only = &cause;
  }
  if (only)
    for (const std::string& effect : only->indistinguishableFrom) names.push_back(causeName(effect));
  return namedOrCounted(std::move(names));
}

std::string gapText(const Diagnosis& diagnosis, const AcceptanceDecision* decision) {
  const std::string closures = failedClosures(diagnosis);
  std::string causes = causesWithProbability(diagnosis);
  if (causes.empty() && decision && isUnexplained(diagnosis)) {
    const std::string text = Phrase::of(
        "Undecided, whatever U is: model and readings disagree, and no catalogued effect explains it");
    //: a sentence, and the signs of what it says
    return closures.empty() ? text : Phrase::of("%1 (signs: %2)", text, closures);
  }
  if (causes.empty()) return withDetails(disagreementText(diagnosis), closures);
  if (isFound(diagnosis, noiseId)) causes = Phrase::of("%1, and noise larger than stated", causes);
  if (const auto alike = lookAlikes(diagnosis); !alike.empty())
    //: causes, and what looks like them
    causes = Phrase::of("%1, indistinguishable here from %2", causes, listed(alike, Phrase::of(" or ")));
  if (!isReached(decision))
    return withDetails(Phrase::of("Model and readings disagree, best explained by %1", causes), closures);
  return withDetails(
      decision->verdict == Verdict::Accept
          ? Phrase::of("Model and readings disagree; accepted only if the cause is %1", causes)
          : Phrase::of("Model and readings disagree; rejected only if the cause is %1", causes),
      closures);
}

std::string jumpText(const Diagnosis& diagnosis, const AcceptanceDecision& decision) {
  const auto [moments, influence] = jumpConditionOf(diagnosis, decision);
  return Phrase::of(
      "The verdict holds only if the tripod was not knocked %1: a knock would move Δd by ± %2 mm undetected, "
      "which U does not include",
      moments, influence);
}

/// The name of an undetectable effect. A jump is "a further jump" if the diagnosis found one.
std::string undetectableName(const Diagnosis& diagnosis, const std::string& effect) {
  const bool isFurther = effect == jumpId && isFound(diagnosis, effect);
  return isFurther ? Phrase::of("a further jump of the orientation") : causeName(effect);
}

/// The effects with an influence above U. A jump is left out if the verdict states it as a condition.
std::string undetectableText(const Diagnosis& diagnosis, double expanded, bool isJumpStated) {
  std::vector<std::string> effects;
  for (const UndetectableEffect& effect : undetectableBeyond(diagnosis, expanded))
    if (!(isJumpStated && effect.effect == jumpId))
      effects.push_back(Phrase::of("%1 ± %2 mm", undetectableName(diagnosis, effect.effect),
                                   displayText(effect.influence, decimalsFor(effect.influence))));
  if (effects.empty()) return "";
  return Phrase::of("Undetectable here and not in U, yet a plausible size moves Δd by more than U: %1",
                    listed(namedOrCounted(std::move(effects)), Phrase::of(" and ")));
}

/// "2 mm", "2 mm (u 0.05 mm)".
std::string referenceGiven(const Measurement& measurement) {
  const std::string reference = displayShortest(*measurement.referenceIntersection);
  return measurement.sigmaReference
             ? Phrase::of("%1 mm (u %2 mm)", reference, displayShortest(*measurement.sigmaReference))
             : Phrase::of("%1 mm", reference);
}

/// The line with the absolute value of E_n (ISO 13528), |Δd − reference|/√(U² + U_ref²). U_ref is σ of the
/// reference times the coverage factor of Δd, fit only.
Line referenceLine(const Measurement& measurement, const SessionFit& fit, const IntersectionEstimate& found) {
  const double difference = found.value - *measurement.referenceIntersection;
  const double own = fit.intersection->coverageFactor * measurement.sigmaReference.value_or(0);
  const double expanded = std::hypot(found.expanded, own), score = std::abs(difference) / expanded;
  const std::string size = sizeWithExpanded(difference, expanded, "mm"), given = referenceGiven(measurement);
  Line line{.kind = Line::Kind::Reference, .text = {}};
  if (!std::isfinite(score)) {
    line.text = Phrase::of("Reference %1: difference %2", given, size);
  } else if (score <= 1) {
    line.text =
        Phrase::of("Reference %1: difference %2, agrees (E_n %3)", given, size, displayText(score, 2));
  } else {
    line.text =
        Phrase::of("Reference %1: difference %2, disagrees (E_n %3)", given, size, displayText(score, 2));
    line.isWarning = true;
  }
  return line;
}

/// The estimate of Δd, measured, or else of Δd, fit only.
IntersectionEstimate estimateIn(const SessionFit& fit, const Diagnosis* diagnosis) {
  return diagnosis && diagnosis->measured ? diagnosis->measured->estimate : estimateOf(*fit.intersection);
}

}  // namespace

bool isDetermined(const Measurement& measurement, double expanded) {
  return expanded < measurement.nominalRadius;
}

std::vector<Line> headlineLines(const Measurement& measurement, const SessionFit& fit,
                                const Diagnosis* diagnosis, const AcceptanceDecision* decision,
                                const std::vector<Dependence>& dependences) {
  std::vector<Line> lines;
  const auto add = [&](Line::Kind kind, std::string text, bool isWarning = true) {
    if (!text.empty()) lines.push_back({.kind = kind, .text = std::move(text), .isWarning = isWarning});
  };
  const bool isJumpStated = decision && !decision->conditions.empty(),
             isOpen = decision && decision->verdict == Verdict::Undecided;
  const MeasuredIntersection* measured = diagnosis && diagnosis->measured ? &*diagnosis->measured : nullptr;
  add(Line::Kind::Interval, intervalText(measurement, fit, estimateIn(fit, diagnosis), measured, decision));
  if (measured) lines.push_back(acrossLine(measurement, *measured));
  if (diagnosis && hasGap(*diagnosis)) add(Line::Kind::Gap, gapText(*diagnosis, decision));
  if (diagnosis && isJumpStated) add(Line::Kind::Jump, jumpText(*diagnosis, *decision));
  add(Line::Kind::Row, dependenceText(dependences));
  if (diagnosis)
    add(Line::Kind::Undetectable,
        undetectableText(*diagnosis, estimateIn(fit, diagnosis).expanded, isJumpStated), !isOpen);
  if (measurement.referenceIntersection)
    lines.push_back(referenceLine(measurement, fit, estimateIn(fit, diagnosis)));
  return lines;
}

}  // namespace alidade
