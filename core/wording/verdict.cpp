#include "core/wording/verdict.h"

#include "core/base/quantity_text.h"
#include "core/wording/closures.h"
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

std::string lengthText(double value, double expanded) {
  const int decimals = decimalsFor(expanded);
  return displayText(value, decimals) + " mm ± " + displayText(expanded, decimals) + " mm";
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
  return "The most of U comes from " + name(most.effect) +
         ", as large as is plausible: measure what shows it.";
}

std::string bothAccounts(const Measurement& measurement, const Intersection& modelled,
                         const Diagnosis& diagnosis, const AcceptanceDecision& decision,
                         const CauseNamer& name) {
  const std::string limit = limitText(*measurement.tolerance);
  const std::string first =
      "By the fit alone, the intersection is " + lengthText(modelled.value, modelled.expanded);
  if (!diagnosis.measured)
    return first + ", " + standing(decision.asModelled, limit) +
           "; but with what the diagnosis found, these readings do not determine it.";
  const IntersectionEstimate& measured = diagnosis.measured->estimate;
  const std::string second =
      "with all that these readings leave possible, it is " + lengthText(measured.value, measured.expanded);
  const std::string coverage = coverageText(measurement.coverage);
  if (decision.asModelled == decision.asFound)
    return first + "; " + second + coverage + agreement(decision.asModelled, limit);
  return first + ", " + standing(decision.asModelled, limit) + "; " + second + coverage + ", " +
         standing(*decision.asFound, "it") + ". " + wayOut(diagnosis, name);
}

}  // namespace

std::string probabilityText(double probability) {
  constexpr double nearlyCertain = 0.9995;
  if (probability >= nearlyCertain) return "more than 99.9 %";
  if (probability < 1 - nearlyCertain) return "less than 0.1 %";
  return displayText(probability * 100, 1) + " %";
}

std::string verdictSentence(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                            const AcceptanceDecision& decision, const CauseNamer& name) {
  if (fit.lengthsInDoubt) return "The verdict is withheld: " + textOf(*fit.lengthsInDoubt);
  if (decision.obstacle == AcceptanceDecision::Obstacle::Coverage)
    return "There is no verdict at a coverage of " + displayShortest(measurement.coverage * 100) +
           " %: state acceptance.coverage as " + displayShortest(leastCoverageOfVerdict) + " or more.";
  const std::string rests = decision.showsBoth
                                ? bothAccounts(measurement, *fit.intersection, *diagnosis, decision, name)
                                : verdictSentence(fit.intersection->value, fit.intersection->expanded,
                                                  *measurement.tolerance, measurement.coverage);
  if (decision.obstacle == AcceptanceDecision::Obstacle::Misclosure)
    return misclosureSentence(*diagnosis) + ' ' + rests;
  if (!decision.conformance) return rests;
  return rests + (decision.showsBoth ? " By all that is possible, it conforms" : " It conforms") +
         " with a probability of " + probabilityText(*decision.conformance) + ".";
}

std::string verdictSentence(double value, double expanded, double tolerance, double coverage) {
  const std::string measured =
      "By the fit alone, the intersection is " + lengthText(value, expanded) + coverageText(coverage);
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
