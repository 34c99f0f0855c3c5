#include "core/wording/verdict.h"

#include "core/base/quantity_text.h"
#include "core/wording/setup_findings.h"

namespace alidade {

namespace {

/// What speaks against the lengths, and what to check.
std::string textOf(const LengthsInDoubt& doubt) {
  const std::string check = "check " + lengthsToCheck(doubt.distance, doubt.nominalRadius) + ".";
  if (!doubt.radius) return "no" + tooShortText(doubt.distance) + ": " + check;
  return "the radius fitted at " + std::to_string(doubt.radius->axisDeg) + "° is " +
         displayText(doubt.radius->percentOff, 0) +
         " % off the nominal one, and lengths that are so far from what they should be prove nothing: " +
         check;
}

}  // namespace

std::string verdictSentence(const Measurement& measurement, const SessionFit& fit) {
  if (!fit.verdict) return {};
  if (fit.lengthsInDoubt) return "The verdict is withheld: " + textOf(*fit.lengthsInDoubt);
  return verdictSentence(fit.intersection->value, fit.intersection->expanded, *measurement.tolerance,
                         measurement.coverage);
}

std::string verdictSentence(double value, double expanded, double tolerance, double coverage) {
  const int decimals = decimalsFor(expanded);
  const std::string measured = "The intersection was measured as " + displayText(value, decimals) + " mm ± " +
                               displayText(expanded, decimals) + " mm (" + displayShortest(coverage * 100) +
                               " % coverage)";
  const std::string limit = "the tolerance of ± " + displayShortest(tolerance) + " mm";
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
