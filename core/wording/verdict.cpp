#include "core/wording/verdict.h"

#include <cmath>

#include "core/base/quantity_text.h"
#include "core/wording/across.h"
#include "core/wording/attainable.h"
#include "core/wording/closures.h"
#include "core/wording/measure.h"
#include "core/wording/position_name.h"
#include "core/wording/setup_findings.h"

namespace alidade {

namespace {

/// What speaks against the lengths, and what to check.
std::string textOf(const LengthsInDoubt& doubt) {
  const std::string check = "check " + lengthsToCheck(doubt.distance, doubt.nominalRadius) + ".";
  if (!doubt.radius) return "no" + tooShortText(doubt.distance) + ": " + check;
  return "the radius fitted at " + positionName(doubt.radius->axisDeg, doubt.radius->time) + " is " +
         displayText(doubt.radius->percentOff, 0) +
         " % off the nominal one, and lengths that are so far from what they should be prove nothing: " +
         check;
}

std::string lengthText(double value, double expanded, double tolerance) {
  return lengthWithUncertainty(value, expanded, decimalsToDecide(value, expanded, tolerance));
}

std::string limitText(double tolerance) {
  return "the tolerance of ± " + displayShortest(tolerance) + " mm";
}

/// " (95 % coverage)".
std::string coverageText(double coverage) {
  return " (" + displayShortest(coverage * 100) + " % coverage)";
}

/// Of one account: where it lies.
std::string standing(Verdict verdict, const std::string& limit) {
  switch (verdict) {
    case Verdict::Accept:
      return "within " + limit;
    case Verdict::Reject:
      return "outside " + limit;
    case Verdict::Undecided:
      break;
  }
  return "not clearly within or outside " + limit;
}

std::string agreement(Verdict verdict, const std::string& limit) {
  if (verdict == Verdict::Undecided)
    return "; with these uncertainties it cannot be said whether it lies within " + limit + ".";
  return "; both lie " + standing(verdict, limit) + ", their uncertainty included.";
}

/// What brings the most to U, and what to do about it.
std::string wayOut(const Diagnosis& diagnosis, const CauseNamer& name) {
  const UncertaintyShare& most = diagnosis.measured->budget.front();
  if (most.effect.empty() || most.from == UncertaintyShare::From::Diagnosis)
    return "Add to the model what was found, or measure what the diagnosis advises.";
  const AttainableUncertainty* easiest = easiestMeasured(diagnosis.attainable);
  return "The most of U comes from " + name(most.effect) + ", as large as is plausible: " +
         (easiest ? "with " + textOf(easiest->measures) + " U would come to some " +
                        displayText(easiest->expanded, decimalsFor(easiest->expanded)) + " mm."
                  : "measure what shows it.");
}

std::string bothAccounts(const Measurement& measurement, const Intersection& modelled,
                         const Diagnosis& diagnosis, const AcceptanceDecision& decision,
                         const CauseNamer& name) {
  const double tolerance = *measurement.tolerance;
  const std::string limit = limitText(tolerance);
  const std::string first =
      "By the fit alone, the intersection is " + lengthText(modelled.value, modelled.expanded, tolerance);
  if (!diagnosis.measured)
    return first + ", " + standing(decision.asModelled, limit) +
           "; but with what the diagnosis found, these readings do not determine it.";
  const IntersectionEstimate& measured = diagnosis.measured->estimate;
  const std::string second = "with all that these readings leave possible, it is " +
                             lengthText(measured.value, measured.expanded, tolerance);
  const std::string coverage = coverageText(measurement.coverage);
  if (decision.asModelled == decision.asFound)
    return first + "; " + second + coverage + agreement(decision.asModelled, limit);
  return first + ", " + standing(decision.asModelled, limit) + "; " + second + coverage + ", " +
         standing(*decision.asFound, "it") + ". " + wayOut(diagnosis, name);
}

/// Of the distance from the axis as a whole, whose parts are known.
std::string distanceText(const Measurement& measurement, const MeasuredIntersection& measured,
                         const AcceptanceDecision& decision) {
  const double tolerance = *measurement.tolerance;
  const auto part = [&](const auto& length) { return lengthText(length.value, length.expanded, tolerance); };
  return "As measured, the distance of the arc's centre from the axis is " + part(*measured.distance) +
         coverageText(measurement.coverage) + ": " + part(measured.estimate) +
         " in the plane of the arc (Δd), " + part(*measured.across) + " across it (Δz); it lies " +
         standing(decision.asFound.value_or(Verdict::Undecided), limitText(tolerance)) +
         ", its uncertainty included.";
}

/// What a tolerance of Δd does not judge.
std::string acrossText(const Measurement& measurement, const Diagnosis* diagnosis) {
  if (measurement.measurand != Measurand::Intersection || !diagnosis || !diagnosis->measured ||
      !liesOff(*diagnosis->measured))
    return "";
  const MeasuredLength& across = *diagnosis->measured->across;
  return " This judges the plane of the arc alone: across it, its centre lies " +
         lengthWithUncertainty(std::abs(across.value), across.expanded, decimalsFor(across.expanded)) +
         " off the axis.";
}

/// What the verdict rests on.
std::string accountsText(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                         const AcceptanceDecision& decision, const CauseNamer& name) {
  if (measurement.measurand == Measurand::Distance && diagnosis && diagnosis->measured &&
      diagnosis->measured->distance)
    return distanceText(measurement, *diagnosis->measured, decision);
  if (decision.showsBoth) return bothAccounts(measurement, *fit.intersection, *diagnosis, decision, name);
  return verdictSentence(fit.intersection->value, fit.intersection->expanded, *measurement.tolerance,
                         measurement.coverage);
}

/// Nothing is certain.
std::string boundedText(double probability, const std::string& more, const std::string& less, int decimals) {
  constexpr double nearlyCertain = 0.9995;
  if (probability >= nearlyCertain) return more + "99.9 %";
  if (probability < 1 - nearlyCertain) return less + "0.1 %";
  return displayText(probability * 100, decimals) + " %";
}

}  // namespace

int decimalsToDecide(double value, double expanded, double tolerance) {
  constexpr int most = 9;
  // In units of the last digit, where what is rounded is whole: 1.308 + 0.211 is no more than 1.519.
  const auto decideRounded = [&](int decimals) {
    constexpr double fine = 1e6;
    const double one = std::pow(10, decimals);
    return decide(std::round(value * one), std::round(expanded * one),
                  std::round(tolerance * one * fine) / fine);
  };
  const Verdict verdict = decide(value, expanded, tolerance);
  int decimals = decimalsFor(expanded);
  while (decimals < most && decideRounded(decimals) != verdict) ++decimals;
  return decimals;
}

bool tellsAcross(const Diagnosis* diagnosis, const AcceptanceDecision& decision) {
  using enum AcceptanceDecision::Obstacle;
  const bool isWithheld = decision.obstacle == Lengths || decision.obstacle == Coverage;
  return !isWithheld && diagnosis && diagnosis->measured && liesOff(*diagnosis->measured);
}

std::string probabilityText(double probability) {
  return boundedText(probability, "more than ", "less than ", 1);
}

std::string shortProbabilityText(double probability) {
  constexpr double nearAnEnd = 0.01;
  const bool isNearAnEnd = probability > 1 - nearAnEnd || probability < nearAnEnd;
  return boundedText(probability, "> ", "< ", isNearAnEnd ? 1 : 0);
}

std::string verdictSentence(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                            const AcceptanceDecision& decision, const CauseNamer& name) {
  if (fit.lengthsInDoubt) return "The verdict is withheld: " + textOf(*fit.lengthsInDoubt);
  if (decision.obstacle == AcceptanceDecision::Obstacle::Coverage)
    return "There is no verdict at a coverage of " + displayShortest(measurement.coverage * 100) +
           " %: state acceptance.coverage as " + displayShortest(leastCoverageOfVerdict) + " or more.";
  const std::string rests =
      accountsText(measurement, fit, diagnosis, decision, name) + acrossText(measurement, diagnosis);
  if (decision.obstacle == AcceptanceDecision::Obstacle::AcrossUnknown)
    return "The tolerance is of the distance from the axis as a whole, and how far the arc's centre lies off "
           "it across the plane of the arc was not measured: read both positions over more of the arc, or "
           "state it (device.known: plane_offset). " +
           rests;
  if (decision.obstacle == AcceptanceDecision::Obstacle::Misclosure)
    return misclosureSentence(*diagnosis) + ' ' + rests;
  if (!decision.conformance) return rests;
  return rests + (decision.showsBoth ? " By all that is possible, it conforms" : " It conforms") +
         " with a probability of " + probabilityText(*decision.conformance) + ".";
}

std::string verdictSentence(double value, double expanded, double tolerance, double coverage) {
  const std::string measured = "By the fit alone, the intersection is " +
                               lengthText(value, expanded, tolerance) + coverageText(coverage);
  const std::string limit = limitText(tolerance);
  switch (decide(value, expanded, tolerance)) {
    case Verdict::Accept:
      return measured + "; it lies within " + limit + ", its uncertainty included.";
    case Verdict::Reject:
      return measured + "; it lies outside " + limit + ", its uncertainty included.";
    case Verdict::Undecided:
      break;
  }
  return measured + "; with this uncertainty it cannot be said whether it lies within " + limit + ".";
}

}  // namespace alidade
