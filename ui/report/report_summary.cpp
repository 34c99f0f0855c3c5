#include "ui/report/report_summary.h"

#include <algorithm>

#include "core/wording/suspects.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_result.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

void addTitle(ReportSheet& sheet, const Session& session) {
  const double title = sheet.lineHeight(type::title);
  sheet.text(QStringLiteral("Acceptance report"), type::title, 0, sheet.y(), ReportSheet::width);
  sheet.text(QStringLiteral("Intersection of a rotatable arc guideway"), type::label, 0,
             sheet.y() + title - sheet.lineHeight(type::label) - 1, ReportSheet::width, Qt::AlignRight);
  sheet.skip(title + 0.5);
  constexpr int longest = 300;
  sheet.paragraph(orNotStated(shortLine(session.title, longest)), type::subtitle);
}

QString severityName(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return QStringLiteral("Note");
    case Severity::Warning:
      return QStringLiteral("Warning");
    case Severity::Error:
      break;
  }
  return QStringLiteral("Error");
}

constexpr std::size_t mostSuspects = 10;

/// Which readings look misread, and what was probably meant.
void addSuspects(ReportSheet& sheet, const std::vector<Suspect>& suspects, const TextStyle& style,
                 double indent) {
  for (std::size_t i = 0; i < std::min(suspects.size(), mostSuspects); ++i)
    sheet.paragraph(QStringLiteral("– ") + qText(sentenceOf(suspects[i])), style, indent);
  if (suspects.size() > mostSuspects)
    sheet.paragraph(QStringLiteral("– and %1 more.").arg(suspects.size() - mostSuspects), style, indent);
}

void addFindings(ReportSheet& sheet, const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const auto misread = suspectsFinding(evaluation.suspects);
  const std::vector<Finding> findings = findingsOf(evaluation);
  sheet.heading(QStringLiteral("Findings"));
  if (!misread && findings.empty() && !gap.isOpen()) {
    const bool isSound = gap.diagnosis && gap.unseenBeyondU().empty();
    sheet.paragraph(!evaluation.fit.intersection ? notStated()
                    : isSound ? QStringLiteral("None: nothing in the data speaks against the result.")
                              : QStringLiteral("None in the data, but see above what they would not show."));
  }
  const TextStyle findingStyle{.points = 8};
  constexpr double indent = 17;
  const auto add = [&](const Finding& finding) {
    sheet.keepTogether(sheet.lineHeight(findingStyle));
    sheet.text(severityName(finding.severity), findingStyle.inBold(), 0, sheet.y(), indent);
    const QString remedy = qText(finding.remedy);
    sheet.paragraph(qText(finding.text) + (remedy.isEmpty() ? QString() : u' ' + remedy), findingStyle,
                    indent);
  };
  if (misread) {
    add(*misread);
    addSuspects(sheet, evaluation.suspects, findingStyle, indent);
  }
  for (const Finding& finding : findings) add(finding);
  if (!gap.isOpen()) return;
  const QString says =
      gap.isNoiseAlone()
          ? gapSentence(gap)
          : QStringLiteral("Model and readings disagree, see “Gap between model and readings”. %1.")
                .arg(gapHeadline(*gap.diagnosis));
  sheet.keepTogether(sheet.lineHeight(findingStyle));
  sheet.text(severityName(Severity::Warning), findingStyle.inBold(), 0, sheet.y(), indent);
  sheet.paragraph(says, findingStyle, indent);
}

QString methodText(const Evaluation& evaluation) {
  const auto& measurement = evaluation.examined.measurement;
  const bool planar = measurement && measurement->relation == VerticalAngleRelation::Planar;
  const QString relation = planar ? QStringLiteral("tan e = y/L (planar, as published)")
                                  : QStringLiteral("tan e = y/√(x² + L²) (exact)");
  return QStringLiteral(
             "Each arc is fitted by rigorous orthogonal least squares on the angles read: the centre, the "
             "radius and the slider's place at each sighting are free, both circles carry errors of the "
             "stated σ. Horizontal angle tan a = x/L, vertical angle %1; frame at the theodolite, x right, "
             "y up.%2 The intersection Δd = (y(O1) − y(O2))/2 is half the distance of the arc centres at 0° "
             "(O1) and 180° (O2) across the axis. The share of the readings in its uncertainty is scaled by "
             "their scatter (s0), pointing zeros and distance enter as stated; the expanded uncertainty U of "
             "the fit alone is k times the combined standard uncertainty, k from Student's distribution. As "
             "measured, every effect of the catalogue takes part, known beforehand to 1σ of its "
             "plausible size, and U also holds what else may explain the readings. Accepted: |Δd| + U ≤ "
             "tolerance; rejected: |Δd| − U > tolerance, by the fit alone and as measured; otherwise "
             "undecided.")
      .arg(relation,
           measurement && hasRepeats(*measurement)
               ? QStringLiteral(" Where an axis is measured again its positions have one centre and "
                                "one radius, and all pointing zeros are estimated along, as well "
                                "known as stated.")
               : QString());
}

constexpr double signatureSpace = 10, signatureHeight = signatureSpace + 6;

void addSignatures(ReportSheet& sheet) {
  constexpr double line = 78;
  sheet.keepTogether(signatureHeight);
  sheet.skip(signatureSpace);
  const double y = sheet.y();
  for (const auto& [left, text] :
       {std::pair(0.0, QStringLiteral("Operator, date")),
        std::pair(ReportSheet::width - line, QStringLiteral("Approved by, date"))}) {
    sheet.rule(left, y, left + line, y, 0.2);
    sheet.text(text, type::label, left, y + 0.8, line);
  }
  sheet.skip(signatureHeight - signatureSpace);
}

double methodHeight(const ReportSheet& sheet, const Evaluation& evaluation) {
  const auto lines = sheet.lines(methodText(evaluation), type::small, ReportSheet::width).size();
  return 10 + static_cast<double>(lines) * sheet.lineHeight(type::small);
}

}  // namespace

bool addSummary(ReportSheet& sheet, const Gap& gap, const ReportOptions& options) {
  const Evaluation& evaluation = *gap.evaluation;
  addTitle(sheet, evaluation.session);
  addFacts(sheet, evaluation, options.date);
  addVerdict(sheet, gap);
  addProblems(sheet, evaluation);
  addResult(sheet, gap);
  addFindings(sheet, gap);
  if (!evaluation.session.notes.empty()) {
    sheet.heading(QStringLiteral("Notes"));
    sheet.paragraph(QString::fromStdString(evaluation.session.notes));
  }
  const bool hasRoom = sheet.room() >= methodHeight(sheet, evaluation) + signatureHeight;
  if (hasRoom) addMethod(sheet, evaluation);
  addSignatures(sheet);
  return hasRoom;
}

void addMethod(ReportSheet& sheet, const Evaluation& evaluation) {
  sheet.keepTogether(methodHeight(sheet, evaluation));
  sheet.heading(QStringLiteral("Method"));
  sheet.paragraph(methodText(evaluation), type::small);
}

}  // namespace alidade::ui
