#include "ui/self_test/installation_check.h"

#include <QPagedPaintDevice>

#include "core/base/atomic_file.h"
#include "core/base/version.h"
#include "core/self_test/self_test.h"
#include "core/self_test/self_test_words.h"
#include "ui/document/encoded_path.h"
#include "ui/report/painted_pdf.h"
#include "ui/report/pdf_archive.h"
#include "ui/report/report_sheet.h"
#include "ui/report/report_text.h"
#include "ui/self_test/window_checks.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

void layOut(ReportSheet& sheet, const InstallationCheck& check) {
  sheet.text(Report::tr("Check of this installation"), type::title, 0, sheet.y(), ReportSheet::width);
  sheet.skip(sheet.lineHeight(type::title) + 0.5);
  sheet.paragraph(qText(verdictSentence(check.test)), type::subtitle);
  sheet.skip(2);
  for (const auto& [name, value] : check.test.environment)
    sheet.paragraph(visibleLine(name + ": " + value), type::detail);
  sheet.skip(2);
  sheet.paragraph(
      Report::sentences({Report::tr("Every number is compared with one computed without this program."),
                         Report::tr("Deviations and tolerances are relative to the expected number.")}));
  for (const CheckSection& section : sectionsOf(check.test)) addStatement(sheet, sectionTable(section));
  sheet.balance();
}

bool paintOn(QPagedPaintDevice& device, const InstallationCheck& check, const ReportPaper& paper) {
  return paintSheets(device,
                     {.product = Report::tr("%1 · Check of this installation").arg(check.product()),
                      .session = {},
                      .fileName = QString(),
                      .fingerprint = {},
                      .date = check.at.toString(QStringLiteral("yyyy-MM-dd HH:mm"))},
                     paper.margins, [&](ReportSheet& sheet) { layOut(sheet, check); });
}

}  // namespace

QString InstallationCheck::product() const {
  return QString::fromStdString("Alidade " + versionAndBuild());
}

InstallationCheck checkInstallation() {
  return checkInstallation(runSelfTest(installedShare()));
}

InstallationCheck checkInstallation(SelfTest ofCore) {
  InstallationCheck check{std::move(ofCore), QDateTime::currentDateTime()};
  check.test.environment.insert(check.test.environment.begin(),
                                {"Qt", std::string(qVersion()) + " (built with " QT_VERSION_STR ")"});
  for (SelfCheck& line : windowChecks()) check.test.checks.push_back(std::move(line));
  return check;
}

bool paintInstallationCheck(QPagedPaintDevice& device, const InstallationCheck& check,
                            const ReportPaper& paper) {
  return paintOn(device, check, paper);
}

Result<QString> writeInstallationCheck(const InstallationCheck& check, const QString& path,
                                       const QStringList& inputs, const ReportPaper& paper) {
  const auto painted =
      paintedPdf(paper, [&](QPagedPaintDevice& device) { return paintOn(device, check, paper); });
  if (!painted) return Problem{Report::tr("%1 cannot be written: painting failed").arg(path).toStdString()};
  const std::string at = check.at.toUTC().toString(Qt::ISODate).toStdString();
  const std::string pdf =
      archivedPdf(*painted,
                  {.title = Report::tr("Check of this installation"),
                   .author = {},
                   .creator = check.product(),
                   .date = check.at},
                  {{.fileName = QStringLiteral("self-test.json"),
                    .description = Report::tr("The results of this check, to be read by programs"),
                    .bytes = selfTestJson(check.test, at)}});
  if (auto problem = writeFile(encodedPath(path), pdf, encodedPaths(inputs))) return *std::move(problem);
  return path;
}

}  // namespace alidade::ui
