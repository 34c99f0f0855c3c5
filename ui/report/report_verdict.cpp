#include "ui/report/report_verdict.h"

#include <algorithm>

#include "core/wording/verdict.h"
#include "ui/text/entry_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

QString wordOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accept:
      return QStringLiteral("Accepted");
    case Verdict::Reject:
      return QStringLiteral("Rejected");
    case Verdict::Undecided:
      break;
  }
  return QStringLiteral("Undecided");
}

QString reasonForNoResult(const Evaluation& evaluation) {
  const std::vector<Finding> findings = findingsOf(evaluation);
  const auto error = std::ranges::find(findings, Severity::Error, &Finding::severity);
  if (error != findings.end()) return qText(error->text);
  return QStringLiteral("The intersection needs an arc at 0° and an arc at 180°; not both are there.");
}

}  // namespace

ReportVerdict reportVerdict(const Evaluation& evaluation) {
  const std::size_t unusable = evaluation.examined.problems.size();
  if (unusable > 0) {
    const QString entries =
        unusable == 1 ? QStringLiteral("1 entry") : QStringLiteral("%1 entries").arg(unusable);
    return {.word = QStringLiteral("No verdict: %1 could not be used").arg(entries),
            .sentence = QStringLiteral(
                "They are listed below. Correct them or exclude their readings; what is printed "
                "here rests on the other readings alone.")};
  }
  const SessionFit& fit = evaluation.fit;
  if (!fit.intersection)
    return {.word = QStringLiteral("No result"), .sentence = reasonForNoResult(evaluation)};
  if (!fit.verdict) {
    return {.word = QStringLiteral("No verdict"),
            .sentence = QStringLiteral("No tolerance stated, so nothing to decide against.")};
  }
  return {.word = wordOf(*fit.verdict),
          .sentence = qText(verdictSentence(*evaluation.examined.measurement, fit)),
          .isAccepted = *fit.verdict == Verdict::Accept};
}

}  // namespace alidade::ui
