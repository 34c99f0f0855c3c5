#include "core/wording/verdict.h"

#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/closures.h"
#include "core/wording/conditions.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"
#include "core/wording/measure.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

/// The reason why the verdict is withheld, and what to check.
std::string withheldBy(const LengthsInDoubt& doubt) {
  const std::string lengths = lengthsToCheck(doubt.distance, doubt.nominalRadius);
  if (!doubt.radius)
    return Phrase::of(
        "The verdict is withheld: no theodolite sights anything at a distance of %1 mm. Check %2.",
        shortestText(doubt.distance), lengths);
  return Phrase::of(
      "The verdict is withheld: the radius fitted at %1 differs from the nominal one by %2 %. Check %3.",
      positionName(doubt.radius->axisDeg, doubt.radius->repeat), displayText(doubt.radius->percentOff, 0),
      lengths);
}

std::string lengthText(double value, double expanded, double tolerance) {
  return lengthWithUncertainty(value, expanded, decimalsToDecide(value, expanded, tolerance));
}

std::string limitText(double tolerance) {
  return Phrase::of("the tolerance of ± %1 mm", displayShortest(tolerance));
}

/// The limit of a distance, which is never negative.
std::string limitOfDistance(double tolerance) {
  return Phrase::of("the tolerance of %1 mm", displayShortest(tolerance));
}

/// "1.31 mm ± 0.21 mm (95 % coverage)".
std::string withCoverage(const std::string& length, double coverage) {
  return Phrase::of("%1 (%2 % coverage)", length, displayPercent(coverage));
}

/// Where a value with its interval lies relative to the limit.
std::string conformityText(Verdict verdict, const std::string& limit) {
  switch (verdict) {
    case Verdict::Accept:
      return Phrase::of("within %1", limit);
    case Verdict::Reject:
      return Phrase::of("outside %1", limit);
    case Verdict::Undecided:
      break;
  }
  return Phrase::of("not clearly within or outside %1", limit);
}

std::string agreement(const std::string& first, const std::string& second, Verdict verdict,
                      const std::string& limit) {
  if (verdict == Verdict::Undecided)
    return Phrase::of(
        "Δd = %2, all effects considered; %1 from the fit only. Neither interval is wholly within or wholly "
        "outside %3.",
        first, second, limit);
  return Phrase::of("Δd = %2, all effects considered; %1 from the fit only. Both intervals are %3.", first,
                    second, conformityText(verdict, limit));
}

/// The largest contribution to U, and what to do about it.
std::string wayOut(const Diagnosis& diagnosis) {
  const UncertaintyShare& most = diagnosis.measured->budget.front();
  if (most.effect.empty() || most.from == UncertaintyShare::From::Diagnosis)
    return diagnosis.causes.empty()
               ? Phrase::of("Take more readings, or measure what the diagnosis advises.")
               : Phrase::of("Add the effects found to the model, or measure what the diagnosis advises.");
  const AttainableUncertainty* easiest = easiestMeasured(diagnosis.attainable);
  return easiest
             ? Phrase::of("Most of U comes from %1 at its plausible size: with %2, U would be about %3 mm.",
                          causeName(most.effect), textOf(easiest->measures),
                          displayText(easiest->expanded, decimalsFor(easiest->expanded)))
             : Phrase::of("Most of U comes from %1 at its plausible size: take readings that show it.",
                          causeName(most.effect));
}

std::string bothEstimates(const Measurement& measurement, const Intersection& modelled,
                          const Diagnosis& diagnosis, const AcceptanceDecision& decision) {
  const double tolerance = *measurement.tolerance;
  const std::string limit = limitText(tolerance);
  const std::string first = lengthText(modelled.value, modelled.expanded, tolerance);
  if (!diagnosis.measured)
    return Phrase::of(
        "Δd = %1 from the fit only, %2. With the causes of the diagnosis, these readings do not determine "
        "Δd.",
        first, conformityText(decision.asModelled, limit));
  const IntersectionEstimate& measured = diagnosis.measured->estimate;
  const std::string second =
      withCoverage(lengthText(measured.value, measured.expanded, tolerance), measurement.coverage);
  if (decision.asModelled == decision.asFound) return agreement(first, second, decision.asModelled, limit);
  return Phrase::of("Δd = %1, all effects considered, is %2; Δd from the fit only, %3, is %4. %5", second,
                    conformityText(*decision.asFound, limit), first,
                    conformityText(decision.asModelled, Phrase::of("it")), wayOut(diagnosis));
}

/// States the distance from the axis and both its parts; `measured` has them.
std::string distanceText(const Measurement& measurement, const MeasuredIntersection& measured,
                         const AcceptanceDecision& decision) {
  const double tolerance = *measurement.tolerance;
  const auto part = [&](const auto& length) { return lengthText(length.value, length.expanded, tolerance); };
  return Phrase::of(
      "The arc's centre is %1 from the axis, all effects considered: %2 in the plane of the arc (Δd), %3 "
      "perpendicular to it (Δz). The interval is %4.",
      withCoverage(part(*measured.distance), measurement.coverage), part(measured.estimate),
      part(*measured.across),
      conformityText(decision.asFound.value_or(Verdict::Undecided), limitOfDistance(tolerance)));
}

/// States what a tolerance of Δd does not cover.
std::string acrossText(const Measurement& measurement, const Diagnosis* diagnosis) {
  if (measurement.measurand != Measurand::Intersection || !diagnosis || !diagnosis->measured ||
      !isAcrossSignificant(*diagnosis->measured))
    return "";
  const MeasuredLength& across = *diagnosis->measured->across;
  return Phrase::of(
      "The verdict covers only the plane of the arc; perpendicular to it, the arc's centre is %1 from the "
      "axis.",
      lengthWithUncertainty(std::abs(across.value), across.expanded, decimalsFor(across.expanded)));
}

/// The values that the verdict is based on: Δd, fit only and measured, or the distance from the axis.
std::string estimatesText(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                          const AcceptanceDecision& decision) {
  if (diagnosis && diagnosis->measured && judgedDistance(measurement, *diagnosis->measured))
    return distanceText(measurement, *diagnosis->measured, decision);
  if (decision.showsBoth) return bothEstimates(measurement, *fit.intersection, *diagnosis, decision);
  return verdictSentence(fit.intersection->value, fit.intersection->expanded, *measurement.tolerance,
                         measurement.coverage);
}

std::string unexplainedText(const Diagnosis& diagnosis) {
  return Phrase::of("With a probability of %1 the gap is real and no catalogued effect explains it.",
                    probabilityText(diagnosis.unexplained.chance));
}

/// The probability of an unexplained gap, and the contribution of unexplained misclosures, if they are large
/// enough to mention.
std::string doubtText(const Diagnosis* diagnosis) {
  constexpr double probable = 0.5;
  constexpr double noticeable = 0.2;  // share of the standard uncertainty; 0.2 increases u by 2 %
  if (!diagnosis || !diagnosis->measured) return "";
  const auto& [chance, sigma] = diagnosis->unexplained;
  const std::string doubt = chance < probable ? "" : unexplainedText(*diagnosis);
  if (sigma < noticeable * diagnosis->measured->estimate.sigma) return doubt;
  const std::string spread = Phrase::of(
      "Misclosures without a catalogued cause add ± %1 mm (1σ); verdict and probability include this amount.",
      displayText(sigma, decimalsFor(sigma)));
  return inTurn(doubt, spread);
}

/// A probability in percent; `more` if close to 1 and `less` if close to 0, so that neither limit is shown.
std::string boundedText(double probability, const std::string& more, const std::string& less, int decimals) {
  constexpr double nearlyCertain = 0.9995;
  if (probability >= nearlyCertain) return more;
  if (probability < 1 - nearlyCertain) return less;
  return displayText(probability * 100, decimals) + " %";
}

}  // namespace

int decimalsToDecide(double value, double expanded, double tolerance) {
  constexpr int most = 9;
  // Compares in units of the last digit, where rounded numbers are whole: 1.308 + 0.211 does not exceed
  // 1.519.
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

std::pair<double, double> endsAsWritten(double value, double expanded, int decimals) {
  const double one = std::pow(10, decimals), shown = std::round(value * one),
               wide = std::round(expanded * one);
  return {(shown - wide) / one, (shown + wide) / one};
}

std::string probabilityText(double probability) {
  return boundedText(probability, Phrase::of("more than 99.9 %"), Phrase::of("less than 0.1 %"), 1);
}

std::string shortProbabilityText(double probability) {
  constexpr double nearAnEnd = 0.01;
  const bool isNearAnEnd = probability > 1 - nearAnEnd || probability < nearAnEnd;
  return boundedText(probability, "> 99.9 %", "< 0.1 %", isNearAnEnd ? 1 : 0);
}

std::string verdictSentence(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                            const AcceptanceDecision& decision) {
  if (fit.lengthsInDoubt) return withheldBy(*fit.lengthsInDoubt);
  if (decision.obstacle == AcceptanceDecision::Obstacle::Coverage)
    return Phrase::of("There is no verdict at a coverage of %1 %: state a coverage of %2 or more.",
                      displayPercent(measurement.coverage), displayShortest(leastCoverageOfVerdict));
  const std::string rests =
      inTurn(estimatesText(measurement, fit, diagnosis, decision), acrossText(measurement, diagnosis));
  if (decision.obstacle == AcceptanceDecision::Obstacle::AcrossUnknown)
    return Phrase::of(
        "The tolerance applies to the whole distance from the axis, and its part perpendicular to the plane "
        "of the arc was not measured: read both positions over more of the arc, or state the known plane "
        "offset of the device. %1",
        rests);
  if (decision.obstacle == AcceptanceDecision::Obstacle::Unexplained)
    return inTurn(Phrase::of("The verdict is open. %1", unexplainedText(*diagnosis)),
                  inTurn(misclosureSentence(*diagnosis), rests));
  const std::string believed = inTurn(rests, doubtText(diagnosis));
  if (!decision.conformance) return believed;
  const std::string probability = probabilityText(*decision.conformance);
  const std::string conforms = Phrase::of("%1 Probability of conformity: %2.", believed, probability);
  return inTurn(conforms, conditionSentence(diagnosis, decision));
}

std::string verdictSentence(double value, double expanded, double tolerance, double coverage) {
  const std::string measured = withCoverage(lengthText(value, expanded, tolerance), coverage);
  const std::string limit = limitText(tolerance);
  switch (decide(value, expanded, tolerance)) {
    case Verdict::Accept:
      return Phrase::of("Δd = %1 from the fit only; the interval is within %2.", measured, limit);
    case Verdict::Reject:
      return Phrase::of("Δd = %1 from the fit only; the interval is outside %2.", measured, limit);
    case Verdict::Undecided:
      break;
  }
  return Phrase::of("Δd = %1 from the fit only; the interval is neither wholly within nor wholly outside %2.",
                    measured, limit);
}

}  // namespace alidade
