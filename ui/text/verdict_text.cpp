#include "ui/text/verdict_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/session/hindrance.h"
#include "core/wording/verdict.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

struct VerdictWords {
  Q_DECLARE_TR_FUNCTIONS(VerdictWords)
};

QString wordOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accept:
      return VerdictWords::tr("Accepted");
    case Verdict::Reject:
      return VerdictWords::tr("Rejected");
    case Verdict::Undecided:
      break;
  }
  return VerdictWords::tr("Undecided");
}

QString reasonForNoResult(const Evaluation& evaluation) {
  const std::vector<Finding> findings = findingsOf(evaluation);
  const auto error = std::ranges::find(findings, Severity::Error, &Finding::severity);
  if (error != findings.end()) return qText(error->text);
  return VerdictWords::tr("The intersection needs an arc at 0° and an arc at 180°; not both are there.");
}

/// `isFinal`: the diagnosis has ended.
VerdictText verdictText(const Evaluation& evaluation, const Diagnosis* diagnosis, bool isFinal) {
  const std::size_t unusable = hindrances(evaluation.session, evaluation.examined.problems).size();
  if (unusable > 0)
    return {
        .word = unusable == 1 ? VerdictWords::tr("No verdict: 1 entry could not be used")
                              : VerdictWords::tr("No verdict: %1 entries could not be used").arg(unusable),
        .sentence = VerdictWords::tr("What cannot be used is listed with its place. Correct it or exclude "
                                     "its reading: what is stated here rests on the others alone.")};
  const SessionFit& fit = evaluation.fit;
  if (!fit.intersection)
    return {.word = VerdictWords::tr("No result"), .sentence = reasonForNoResult(evaluation)};
  const Measurement& measurement = *evaluation.examined.measurement;
  const QString provisional = VerdictWords::tr("Provisional: the diagnosis is running.");
  auto decision = decideAcceptance(measurement, fit, diagnosis);
  if (!decision && !isFinal) return {.word = provisional, .sentence = {}};
  if (!decision)
    return {.word = VerdictWords::tr("No verdict"),
            .sentence = VerdictWords::tr("No tolerance stated, so nothing to decide against.")};
  if (!isFinal) decision->conformance.reset();
  const QString sentence = qText(verdictSentence(measurement, fit, diagnosis, *decision, causeNameInCore));
  if (!isFinal) return {.word = provisional, .sentence = sentence};
  const QString word = wordOf(decision->verdict);
  if (!diagnosis) return {.word = VerdictWords::tr("%1, fit only").arg(word), .sentence = sentence};
  return {.word = word,
          .sentence = sentence,
          .verdict = decision->verdict,
          .tellsAcross = tellsAcross(diagnosis, *decision)};
}

}  // namespace

VerdictText verdictText(const Evaluation& evaluation, const Diagnosis* diagnosis) {
  return verdictText(evaluation, diagnosis, true);
}

VerdictText provisionalVerdict(const Evaluation& evaluation) {
  return verdictText(evaluation, nullptr, false);
}

State stateOf(const VerdictText& verdict) {
  if (!verdict.verdict) return State::Quiet;
  switch (*verdict.verdict) {
    case Verdict::Accept:
      return State::Good;
    case Verdict::Reject:
      return State::Bad;
    case Verdict::Undecided:
      break;
  }
  return State::Open;
}

QString intersectionText(const Measurement& measurement, double value, double expanded) {
  const int decimals = measurement.tolerance ? decimalsToDecide(value, expanded, *measurement.tolerance)
                                             : decimalsFor(expanded);
  return valueWithUncertainty(value, expanded, QStringLiteral("mm"), decimals);
}

}  // namespace alidade::ui
