#include "ui/instrument/check_report.h"

#include <QPagedPaintDevice>

#include "core/base/version.h"
#include "core/series/instrument_check/check_statement.h"
#include "core/series/instrument_check/instrument_json.h"
#include "ui/instrument/check_plot.h"
#include "ui/report/painted_pdf.h"
#include "ui/report/pdf_archive.h"
#include "ui/report/report_parts.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

QString nameOf(const CheckIdentity& identity) {
  QStringList parts;
  for (const std::string* part : {&identity.name, &identity.serial})
    if (!part->empty()) parts.append(visibleLine(*part));
  return parts.isEmpty() ? Report::tr("instrument without a name") : listText(parts);
}

/// Adds the stations as two tables, since one table with all columns is wider than the page.
void addStations(ReportSheet& sheet, const InstrumentCheck& check) {
  const Statement whole = stationsTable(check);
  const auto part = [&](const std::vector<std::size_t>& columns) {
    Statement statement{.id = whole.id, .title = whole.title, .columns = {}, .rows = {}};
    for (const std::size_t column : columns) statement.columns.push_back(whole.columns[column]);
    for (const Statement::Row& row : whole.rows) {
      Statement::Row own{.cells = {}, .isTotal = row.isTotal};
      for (const std::size_t column : columns) own.cells.push_back(row.cells[column]);
      statement.rows.push_back(std::move(own));
    }
    return statement;
  };
  addStatement(sheet, part({0, 1, 2, 3}));
  Statement faces = part({0, 4, 5, 6, 7});
  faces.title = Report::tr("Axes and circles").toStdString();
  faces.note = whole.note;
  addStatement(sheet, faces);
}

void addFindings(ReportSheet& sheet, const CheckedInstrument& answer) {
  sheet.heading(Report::tr("Findings"));
  for (const Finding& finding : answer.findings)
    sheet.paragraph((finding.severity == Severity::Note ? QStringLiteral("• ") : QStringLiteral("⚠ ")) +
                    visibleLine(finding.remedy.empty() ? finding.text : finding.text + " " + finding.remedy));
  for (const std::string& remark : answer.remarks)
    sheet.paragraph(QStringLiteral("• ") + capitalised(visibleLine(remark)) + u'.');
}

void layOut(ReportSheet& sheet, const SharedInstrument& answer) {
  const InstrumentCheck& check = *answer->check;
  sheet.text(Report::tr("Instrument check"), type::title, 0, sheet.y(), ReportSheet::width);
  sheet.skip(sheet.lineHeight(type::title) + 0.5);
  sheet.paragraph(nameOf(answer->identity), type::subtitle);
  sheet.skip(2);
  addStatement(sheet, checkVerdict(check, answer->findings));
  addStatement(sheet, identityTable(answer->identity));
  addStations(sheet, check);
  constexpr double chartHeight = 70;
  sheet.keepTogether(chartHeight + 12);
  sheet.heading(Report::tr("Values over the rounds"));
  const auto plot = std::make_shared<CheckPlot>();
  plot->setCheck(answer);
  addPlot(sheet, plot, chartHeight);
  addFindings(sheet, *answer);
  for (const StationCheck& station : check.stations)
    for (const Statement& details : stationDetails(station)) addStatement(sheet, details);
  sheet.balance();
}

}  // namespace

std::optional<std::string> checkPdf(const CheckedInstrument& answer, const ReportPaper& paper,
                                    const QDateTime& date) {
  const QString name = nameOf(answer.identity);
  QStringList files;
  for (const std::string& source : answer.sources) files.append(visibleLine(source));
  const auto painted = paintedPdf(paper, [&](QPagedPaintDevice& pages) {
    return paintSheets(pages,
                       {.product = Report::tr("Alidade %1 · Instrument check").arg(qText(versionAndBuild())),
                        .session = name,
                        .fileName = listText(files),
                        .fingerprint = {},
                        .date = date.toString(QStringLiteral("yyyy-MM-dd HH:mm"))},
                       paper.margins, [&](ReportSheet& sheet) {
                         layOut(sheet, std::make_shared<const CheckedInstrument>(answer));
                       });
  });
  if (!painted) return std::nullopt;
  return archivedPdf(
      *painted,
      {.title = Report::tr("Instrument check: %1").arg(name),
       .author = {},
       .creator = qText("Alidade " + versionAndBuild()),
       .date = date},
      {{.fileName = QStringLiteral("instrument-check.json"),
        .description = Report::tr("The results of this check, to be read by programs"),
        .bytes = instrumentJson(answer.identity, *answer.check, answer.findings, answer.remarks)}});
}

}  // namespace alidade::ui
