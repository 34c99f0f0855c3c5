#include "core/statement/headline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/diagnosis/decision.h"
#include "core/evaluation/evaluation.h"
#include "core/session/hindrance.h"
#include "core/statement/gap.h"
#include "core/statement/headline_lines.h"
#include "core/wording/closures.h"
#include "core/wording/journal.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

constexpr const char* distanceName = "d";

std::string wordOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accept:
      return Phrase::of("Accepted");
    case Verdict::Reject:
      return Phrase::of("Rejected");
    case Verdict::Undecided:
      break;
  }
  return Phrase::of("Undecided");
}

std::string toleranceText(const Measurement& measurement) {
  if (!measurement.tolerance) return "";
  const std::string size = displayShortest(*measurement.tolerance);
  return measurement.measurand == Measurand::Distance ? Phrase::of("tolerance %1 mm", size)
                                                      : Phrase::of("tolerance ± %1 mm", size);
}

/// Enough digits for the reader to reach the same verdict.
int decimalsOf(const Measurement& measurement, double value, double expanded) {
  return measurement.tolerance ? decimalsToDecide(value, expanded, *measurement.tolerance)
                               : decimalsFor(expanded);
}

/// "1.30 ± 0.74 mm".
std::string figureText(const Measurement& measurement, double value, double expanded) {
  const int decimals = decimalsOf(measurement, value, expanded);
  return Phrase::of("%1 ± %2 mm", displayText(value, decimals), displayText(expanded, decimals));
}

std::string exactly(double value, double expanded) {
  return Phrase::of("Δd = %1 mm, U = %2 mm", displayText(value, 6), displayText(expanded, 6));
}

std::string measuredTip(const Measurement& measurement, const MeasuredIntersection& measured) {
  return Phrase::of(
      "%1 at %2 % coverage.\nIncludes every catalogued effect, limited by these readings or by its plausible "
      "size. The "
      "page Budget lists what each contributes.\n%3",
      exactly(measured.estimate.value, measured.estimate.expanded), displayPercent(measurement.coverage),
      acrossSentence(measured));
}

/// Sets name and figure, and with a tolerance and a finite U the scale of the tolerance.
void setFigure(Headline& headline, const Measurement& measurement, const std::string& name, double value,
               double expanded) {
  headline.name = name;
  headline.figure = figureText(measurement, value, expanded);
  if (measurement.tolerance && std::isfinite(expanded))
    headline.scale =
        ToleranceScale{std::abs(value), expanded, *measurement.tolerance,
                       name == distanceName ? "d ± U" : "|Δd| ± U", decimalsOf(measurement, value, expanded)};
}

/// A headline with the tolerance and Δd, fit only; the other parts are still to be set.
Headline frameOf(const Measurement& measurement, const SessionFit& fit) {
  Headline headline{.name = Phrase::of("Δd"), .figure = "—", .tolerance = toleranceText(measurement)};
  if (!fit.intersection) return headline;
  const Intersection& fitted = *fit.intersection;
  headline.fitOnly = Phrase::of("Δd, fit only: %1", figureText(measurement, fitted.value, fitted.expanded));
  headline.fitOnlyDetails =
      Phrase::of("U at %1 % coverage (k = %2); u = %3 mm", displayPercent(fitted.coverage),
                 displayText(fitted.coverageFactor, 2), displayText(fitted.sigma, decimalsFor(fitted.sigma)));
  return headline;
}

void setMeasured(Headline& headline, const Measurement& measurement, const MeasuredIntersection& measured) {
  headline.isMeasured = true;
  if (!isDetermined(measurement, measured.estimate.expanded)) {
    headline.name = Phrase::of("Δd");
    headline.figure = Phrase::of("not determined by these readings");
    headline.tip = measuredTip(measurement, measured);
    headline.isMeasured = false;
    return;
  }
  if (measured.across)
    headline.offset = CentreOffset{.inPlane = measured.estimate.value,
                                   .inPlaneExpanded = measured.estimate.expanded,
                                   .across = measured.across->value,
                                   .acrossExpanded = measured.across->expanded,
                                   .tolerance = measurement.tolerance,
                                   .isOfDistance = measurement.measurand == Measurand::Distance};
  headline.tip = measuredTip(measurement, measured);
  if (const MeasuredLength* distance = judgedDistance(measurement, measured))
    setFigure(headline, measurement, distanceName, distance->value, distance->expanded);
  else
    setFigure(headline, measurement, headline.name, measured.estimate.value, measured.estimate.expanded);
}

/// Sets the verdict and its basis. Without a diagnosis the verdict says "fit only" and `decided` is absent.
void setVerdict(Headline& headline, const Measurement& measurement, const SessionFit& fit,
                const Diagnosis* diagnosis, const std::optional<AcceptanceDecision>& decision) {
  if (!decision) {
    headline.verdict = Phrase::of("No verdict");
    headline.sentence = Phrase::of("No tolerance is stated, so there is no verdict.");
    return;
  }
  headline.verdict = wordOf(decision->verdict);
  headline.sentence = verdictSentence(measurement, fit, diagnosis, *decision);
  if (diagnosis)
    headline.decided = decision->verdict;
  else
    headline.verdict = Phrase::of("%1, fit only", headline.verdict);
}

std::string reasonForNoResult(const Evaluation& evaluation) {
  const std::vector<Finding> findings = findingsOf(evaluation);
  const auto error = std::ranges::find(findings, Severity::Error, &Finding::severity);
  if (error != findings.end()) return error->text;
  return Phrase::of("The intersection needs an arc at 0° and an arc at 180°; at least one is missing.");
}

/// The text in place of a verdict.
struct NoVerdict {
  std::string word, sentence;
};

/// Why the evaluation has no verdict; absent if it may have one.
std::optional<NoVerdict> whyNoVerdict(const Evaluation& evaluation) {
  const std::size_t unusable = hindrances(evaluation.session, evaluation.examined.problems).size();
  if (unusable > 0 && evaluation.fit.intersection)
    return NoVerdict{unusable == 1 ? Phrase::of("No verdict: 1 entry could not be used")
                                   : Phrase::of("No verdict: %1 entries could not be used", unusable),
                     Phrase::of("Entries that cannot be used are listed with their place. Correct each or "
                                "exclude its reading: the result stated here uses only the other entries.")};
  if (!evaluation.fit.intersection) return NoVerdict{Phrase::of("No result"), reasonForNoResult(evaluation)};
  return std::nullopt;
}

void withhold(Headline& headline, const NoVerdict& none) {
  headline.verdict = none.word;
  headline.sentence = none.sentence;
}

Headline frameOf(const Evaluation& evaluation) {
  if (evaluation.examined.measurement) return frameOf(*evaluation.examined.measurement, evaluation.fit);
  return {.name = Phrase::of("Δd"), .figure = "—"};
}

void addSeal(Headline& headline, const Session& session) {
  const auto seal = sealOf(session.journal);
  if (seal)
    headline.lines.push_back({.kind = Headline::Line::Kind::Seal,
                              .text = sealState(session.journal),
                              .isWarning = changesSince(*seal, session.journal) > 0});
}

/// The result of a diagnosed fit, or why there is no result, with the lines below it. Without a decision no
/// line mentions a verdict.
Headline resultOf(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                  const std::optional<AcceptanceDecision>& decision,
                  const std::vector<Dependence>& dependences) {
  Headline headline = frameOf(measurement, fit);
  if (!fit.intersection) return headline;
  if (diagnosis && diagnosis->measured)
    setMeasured(headline, measurement, *diagnosis->measured);
  else
    headline.figure =
        diagnosis ? Phrase::of("not determined by these readings") : Phrase::of("no diagnosis was made");
  headline.lines = headlineLines(measurement, fit, diagnosis, decision ? &*decision : nullptr, dependences);
  return headline;
}

}  // namespace

std::string Headline::nameAndFigure() const {
  //: a name and what it is: "Δd: not determined by these readings"
  return fitOnly.empty() || !(isMeasured || isProvisional) ? Phrase::of("%1: %2", name, figure)
                                                           : Phrase::of("%1 = %2", name, figure);
}

std::string Headline::verdictAndTolerance() const {
  return tolerance.empty() ? verdict : verdict + " · " + tolerance;
}

std::string Headline::line(Line::Kind kind) const {
  const auto found = std::ranges::find(lines, kind, &Line::kind);
  return found == lines.end() ? "" : found->text;
}

std::string Headline::condition() const {
  const std::string gap = line(Line::Kind::Gap), jump = line(Line::Kind::Jump);
  return gap.empty() || jump.empty() ? gap + jump : Phrase::of("%1. %2", gap, jump);
}

Headline headlineOf(const Evaluation& evaluation) {
  Headline headline = frameOf(evaluation);
  const auto& fitted = evaluation.fit.intersection;
  if (fitted) {
    const Measurement& measurement = *evaluation.examined.measurement;
    setFigure(headline, measurement, Phrase::of("Δd, fit only"), fitted->value, fitted->expanded);
    headline.tip = exactly(fitted->value, fitted->expanded);
    headline.isProvisional = true;
    headline.verdict = Phrase::of("Provisional: the diagnosis is running.");
  }
  if (const auto none = whyNoVerdict(evaluation)) withhold(headline, *none);
  addSeal(headline, evaluation.session);
  return headline;
}

Headline headlineOf(const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const SessionFit& fit = evaluation.fit;
  const std::optional<NoVerdict> none = whyNoVerdict(evaluation);
  Headline headline = !fit.intersection ? frameOf(evaluation)
                      : none            ? resultOf(*evaluation.examined.measurement, fit, gap.found(), {}, {})
                                        : headlineOf(*evaluation.examined.measurement, fit, gap.found(),
                                                     gap.dependences.value_or(std::vector<Dependence>()));
  if (none) withhold(headline, *none);
  if (fit.intersection && !gap.measured()) headline.tip = reasonForNone(gap);
  addSeal(headline, evaluation.session);
  return headline;
}

Headline headlineOf(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                    const std::vector<Dependence>& dependences) {
  const auto decision = decideAcceptance(measurement, fit, diagnosis);
  Headline headline = resultOf(measurement, fit, diagnosis, decision, dependences);
  if (fit.intersection) setVerdict(headline, measurement, fit, diagnosis, decision);
  return headline;
}

}  // namespace alidade
