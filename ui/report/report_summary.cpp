#include "ui/report/report_summary.h"

#include <algorithm>

#include "ui/report/report_facts.h"
#include "ui/report/report_result.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

void addTitle(ReportSheet& sheet, const Session& session) {
  sheet.text(QStringLiteral("Acceptance report"), type::title, 0, sheet.y(), ReportSheet::width);
  sheet.skip(sheet.lineHeight(type::title));
  sheet.paragraph(QStringLiteral("Intersection of a rotatable arc guideway"), type::label);
  sheet.skip(1);
  sheet.paragraph(orNotStated(QString::fromStdString(session.title)), type::subtitle);
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

void addFindings(ReportSheet& sheet, const std::vector<Finding>& findings) {
  sheet.heading(QStringLiteral("Findings"));
  if (findings.empty())
    sheet.paragraph(QStringLiteral("None: nothing in the data speaks against the result."));
  constexpr double indent = 17;
  for (const Finding& finding : findings) {
    sheet.keepTogether(sheet.lineHeight(type::body));
    sheet.text(severityName(finding.severity), type::body.inBold(), 0, sheet.y(), indent);
    const QString remedy = sentenceText(finding.remedy);
    sheet.paragraph(sentenceText(finding.text) + (remedy.isEmpty() ? QString() : u' ' + remedy), type::body,
                    indent);
  }
}

void addMethod(ReportSheet& sheet, const Evaluation& evaluation) {
  const auto& measurement = evaluation.examined.measurement;
  const bool planar = measurement && measurement->relation == VerticalAngleRelation::Planar;
  const QString relation = planar ? QStringLiteral("tan e = y/L (planar, as published)")
                                  : QStringLiteral("tan e = y/√(x² + L²) (exact)");
  sheet.heading(QStringLiteral("Method"));
  sheet.paragraph(
      QStringLiteral(
          "Each arc is fitted by rigorous orthogonal least squares on the angles read: the centre, the "
          "radius and the slider's place at each sighting are free, both circles carry errors of the "
          "stated σ. Horizontal angle tan a = x/L, vertical angle %1; frame at the theodolite, x right, "
          "y up. The intersection Δd = (y(O1) − y(O2))/2 is half the distance of the arc centres at 0° "
          "(O1) and 180° (O2) across the axis. The share of the readings in its uncertainty is scaled by "
          "their scatter (s0), pointing zeros and distance enter as stated; the expanded uncertainty U is "
          "k times the combined standard uncertainty, k from Student's distribution. Accepted: |Δd| + U ≤ "
          "tolerance; rejected: |Δd| − U > tolerance; otherwise undecided.")
          .arg(relation));
}

void addSignatures(ReportSheet& sheet) {
  constexpr double line = 78, space = 17;
  sheet.keepTogether(space + 6);
  sheet.skip(space);
  const double y = sheet.y();
  for (const auto& [left, text] :
       {std::pair(0.0, QStringLiteral("Operator, date")),
        std::pair(ReportSheet::width - line, QStringLiteral("Approved by, date"))}) {
    sheet.rule(left, y, left + line, y, 0.2);
    sheet.text(text, type::label, left, y + 0.8, line);
  }
  sheet.skip(6);
}

}  // namespace

void addSummary(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date) {
  addTitle(sheet, evaluation.session);
  addFacts(sheet, evaluation, date);
  addVerdict(sheet, evaluation);
  addProblems(sheet, evaluation.examined.problems);
  addResult(sheet, evaluation);
  addFindings(sheet, evaluation.fit.findings);
  if (!evaluation.session.notes.empty()) {
    sheet.heading(QStringLiteral("Notes"));
    sheet.paragraph(QString::fromStdString(evaluation.session.notes));
  }
  addMethod(sheet, evaluation);
  addSignatures(sheet);
}

}  // namespace alidade::ui
