#include "ui/report/report_summary.h"

#include <QPainter>
#include <algorithm>

#include "core/evaluation/evaluation.h"
#include "core/statement/reliability.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/suspects.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_text.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {
namespace {

/// The number of the report: "No. 2026-117"; empty if there is none.
QString reportNumber(const Session& session) {
  constexpr int longest = 40;
  const QString number = shortLine(qText(session.report.number).trimmed(), longest);
  //: the number of a report
  return number.isEmpty() ? number : Report::tr("No. %1").arg(number);
}

/// Draws the logo at the right, as large as allowed; returns its height.
double addLogo(ReportSheet& sheet, const QImage& logo) {
  if (logo.isNull()) return 0;
  constexpr double mostWidth = 60, mostHeight = 15;
  const QSizeF size = QSizeF(logo.size()).scaled(mostWidth, mostHeight, Qt::KeepAspectRatio);
  const QRectF area(QPointF(ReportSheet::width - size.width(), sheet.y()), size);
  sheet.draw([logo, target = sheet.inDeviceUnits(area)](QPainter& painter) {
    painter.setRenderHint(QPainter::LosslessImageRendering);
    painter.drawImage(target, logo);
  });
  return size.height();
}

/// The subtitle is at the right of the title; below it if there is a logo or the line is too short for both.
void addTitle(ReportSheet& sheet, const Session& session, const QImage& logo) {
  const double title = sheet.lineHeight(type::title), subtitle = sheet.lineHeight(type::label);
  const double logoHeight = addLogo(sheet, logo);
  const QString says = Report::tr("Acceptance report"),
                ofWhat = Report::tr("Intersection of a rotatable arc guideway");
  constexpr double beside = 6;
  const double taken = sheet.textWidth(says, type::title) + beside + sheet.textWidth(ofWhat, type::label);
  const bool isBelow = logoHeight > 0 || taken > ReportSheet::width;
  sheet.text(says, type::title, 0, sheet.y(), ReportSheet::width);
  sheet.text(ofWhat, type::label, 0, sheet.y() + title - (isBelow ? 0.5 : subtitle + 1), ReportSheet::width,
             isBelow ? Qt::AlignLeft : Qt::AlignRight);
  sheet.skip(isBelow ? std::max(logoHeight, title + subtitle) + 1.5 : title + 0.5);
  constexpr int longest = 300;
  const QString number = reportNumber(session), name = shortLine(session.title, longest);
  if (!number.isEmpty()) {
    sheet.text(number, type::subtitle, 0, sheet.y(), ReportSheet::width, Qt::AlignRight);
    const double both =
        sheet.textWidth(name, type::subtitle) + beside + sheet.textWidth(number, type::subtitle);
    if (name.isEmpty() || both > ReportSheet::width) sheet.skip(sheet.lineHeight(type::subtitle));
  }
  if (!name.isEmpty()) sheet.paragraph(name, type::subtitle);
}

QString severityName(Severity severity) {
  switch (severity) {
    //: how serious a finding is: Note, Warning or Error
    case Severity::Note:
      return Report::tr("Note");
    case Severity::Warning:
      return Report::tr("Warning");
    case Severity::Error:
      break;
  }
  return Report::tr("Error");
}

/// The left edge of the findings, after their severity.
double findingsIndent(const ReportSheet& sheet) {
  double indent = 17;
  for (const Severity severity : {Severity::Note, Severity::Warning, Severity::Error})
    indent = std::max(indent, sheet.textWidth(severityName(severity), type::detail.inBold()) + 2);
  return indent;
}

void addFindings(ReportSheet& sheet, const Gap& gap) {
  const Evaluation& evaluation = *gap.evaluation;
  const auto misread = suspectsFinding(evaluation.suspects);
  const std::vector<Finding> findings = findingsOf(evaluation);
  sheet.heading(Report::tr("Findings"));
  if (!misread && findings.empty() && !gap.isOpen()) {
    const bool isSound = gap.diagnosis && gap.undetectableBeyondU().empty();
    sheet.paragraph(!evaluation.fit.intersection ? Report::tr("None.")
                    : isSound ? Report::tr("None: nothing in the data speaks against the result.")
                              : Report::tr("None in the data, but see the undetectable effects above."));
  }
  const double indent = findingsIndent(sheet);
  const auto say = [&](Severity severity, const QString& text) {
    sheet.keepStart(text, type::detail, indent);
    sheet.text(severityName(severity), type::detail.inBold(), 0, sheet.y(), indent);
    sheet.paragraph(text, type::detail, indent);
  };
  const auto add = [&](const Finding& finding) {
    say(finding.severity, Report::sentences({qText(finding.text), qText(finding.remedy)}));
  };
  if (misread) add(*misread);
  for (const Finding& finding : findings) {
    if (&finding != &findings.front()) sheet.mayBreak();
    add(finding);
  }
  if (!gap.isOpen()) return;
  const QString says =
      gap.isNoiseAlone()
          ? qText(sentenceOf(*gap.diagnosis))
          : Report::tr("Model and readings disagree, see “Gap between model and readings”. %1.")
                .arg(gapHeadline(*gap.diagnosis));
  say(Severity::Warning, Report::sentences({says, qText(staleSentence(*gap.diagnosis))}));
}

QString methodText(const Evaluation& evaluation) {
  const auto& measurement = evaluation.examined.measurement;
  const bool planar = measurement && measurement->relation == VerticalAngleRelation::Planar;
  const QString relation =
      planar ? Report::tr("tan e = y/L (planar, as published)") : Report::tr("tan e = y/√(x² + L²) (exact)");
  QStringList sentences{
      Report::tr(
          "Each arc is fitted by rigorous orthogonal least squares on the angles read: the centre, the "
          "radius and the slider's place at each sighting are free, both circles carry errors of the "
          "stated σ. Horizontal angle tan a = x/L, vertical angle %1; frame at the theodolite, x "
          "right, y up.")
          .arg(relation)};
  if (measurement && hasRepeats(*measurement))
    sentences.append(
        Report::tr("Positions at the same axis angle share one centre and one radius; all pointing zeros are "
                   "estimated too, with their stated uncertainty."));
  sentences.append(Report::tr(
      "The intersection Δd = (y(O1) − y(O2))/2 is half the difference of the heights of the arc centres at "
      "0° (O1) and 180° (O2). The share of the readings in its uncertainty is scaled by their scatter (s0); "
      "pointing zeros and distance enter with their stated uncertainty. The expanded uncertainty U of Δd, "
      "fit only, is k times the combined standard uncertainty, with k from Student's distribution with ν "
      "effective degrees of freedom. Δd, measured, includes every effect of the catalogue, with its "
      "plausible size (1σ) as prior knowledge; its U also covers other explanations of the readings."));
  return Report::sentences(sentences);
}

constexpr double signatureSpace = 7, signatureHeight = signatureSpace + 5;

/// The text below a signature line: `named` with `name`, or `unnamed` if `name` is empty.
QString signatureText(const QString& unnamed, const QString& named, const std::string& name) {
  constexpr int longest = 36;
  const QString who = shortLine(qText(name).trimmed(), longest);
  return who.isEmpty() ? unnamed : named.arg(who);
}

double methodHeight(const ReportSheet& sheet, const Evaluation& evaluation) {
  const auto lines = sheet.lines(methodText(evaluation), type::small, ReportSheet::width).size();
  return 10 + static_cast<double>(lines) * sheet.lineHeight(type::small);
}

}  // namespace

FrontPage addSummary(ReportSheet& sheet, const Gap& gap, const ReportOptions& options) {
  const Evaluation& evaluation = *gap.evaluation;
  addTitle(sheet, evaluation.session, options.logo);
  addFacts(sheet, evaluation, options.date);
  addVerdict(sheet, gap);
  addTerms(sheet, gap, options.contents);
  addProblems(sheet, evaluation);
  addResult(sheet, gap);
  addFindings(sheet, gap);
  addStatement(sheet, suspectTable(evaluation.suspects));
  if (!evaluation.session.notes.empty()) {
    sheet.heading(Report::tr("Notes"));
    sheet.paragraph(QString::fromStdString(evaluation.session.notes));
  }
  FrontPage front{.hasMethod = !isPrinted(ReportPart::Method, options.contents, gap),
                  .isSigned = !isPrinted(ReportPart::Signatures, options.contents, gap)};
  if (!front.hasMethod && sheet.room() >= methodHeight(sheet, evaluation) + signatureHeight) {
    addMethod(sheet, evaluation);
    front.hasMethod = true;
  }
  if (!front.isSigned && sheet.room() >= signatureHeight) {
    addSignatures(sheet, evaluation.session);
    front.isSigned = true;
  }
  return front;
}

void addSignatures(ReportSheet& sheet, const Session& session) {
  constexpr double line = 78;
  sheet.keepTogether(signatureHeight);
  sheet.skip(signatureSpace);
  const double y = sheet.y();
  //: below a line to be signed and dated; %1: the name
  const QString operators = Report::tr("Operator: %1, date"),
                authorised = Report::tr("Authorised by: %1, date");
  for (const auto& [left, text] :
       {std::pair(0.0, signatureText(Report::tr("Operator, date"), operators, session.operatorName)),
        std::pair(ReportSheet::width - line, signatureText(Report::tr("Authorised by, date"), authorised,
                                                           session.report.authorisedBy))}) {
    sheet.rule(left, y, left + line, y, 0.2);
    sheet.text(sheet.elided(text, type::label, line), type::label, left, y + 0.8, line);
  }
  sheet.skip(signatureHeight - signatureSpace);
}

bool addMethodInTheRest(ReportSheet& sheet, const Evaluation& evaluation) {
  const bool isRest = sheet.room() < sheet.height() / 2;
  if (!isRest || sheet.room() < methodHeight(sheet, evaluation)) return false;
  addMethod(sheet, evaluation);
  return true;
}

void addMethod(ReportSheet& sheet, const Evaluation& evaluation) {
  sheet.keepTogether(methodHeight(sheet, evaluation));
  sheet.heading(Report::tr("Method"));
  sheet.paragraph(methodText(evaluation), type::small);
}

}  // namespace alidade::ui
