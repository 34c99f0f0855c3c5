#include "ui/report/report_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>

#include "core/base/file_bytes.h"
#include "core/session/session_file.h"
#include "tests/ui/language/speaking.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/report/attached_session.h"

// Extracts the results from the report by qpdf, and compares them with the console's output.

namespace alidade::ui {
namespace {

const QString results = QStringLiteral("results.json");

QString attachment(const Printed& report, const QString& name) {
  return report.tool(QStringLiteral("qpdf"), {QStringLiteral("--show-attachment=") + name, report.path()});
}

QString attachments(const Printed& report) {
  return report.tool(QStringLiteral("qpdf"), {QStringLiteral("--list-attachments"), report.path()});
}

QString printedByConsole(const QString& path) {
  QProcess console;
  console.start(QStringLiteral(ALIDADE_CLI), {QStringLiteral("fit"), path, QStringLiteral("--json")});
  EXPECT_TRUE(console.waitForFinished(60000));
  return QString::fromUtf8(console.readAllStandardOutput());
}

TEST(ReportResults, AreWhatTheConsolePrintsInEveryLanguage) {
  for (const char* sample : {"paper-table-1", "knocked-tripod", "two-faces", "misreading"})
    for (const char* language : {"en", "zh_CN"}) {
      const Speaking speaking(QString::fromLatin1(language));
      const QString path = samplePath(QStringLiteral("%1.alidade").arg(QString::fromLatin1(sample)));
      const Session session = *loadSession(path.toStdString());
      const Printed report(session);
      const QString printed = printedByConsole(path);
      EXPECT_TRUE(printed.contains(QStringLiteral("\"budget_of_fit\""))) << "with the diagnosis";
      EXPECT_EQ(attachment(report, results), printed) << sample << ' ' << language;
    }
}

// The report's reader must be able to repeat the fit from the attached session.
TEST(ReportResults, AreThoseOfTheAttachedSession) {
  Session session = paperSession();
  session.title.clear();
  session.positions[0].readings[3].excluded = true;
  session.model.effects = {"trunnion_tilt"};
  const Printed report(session, {.fileName = QStringLiteral("Führung 7.alidade"),
                                 .sha256 = {},
                                 .saved = false,
                                 .paths = {},
                                 .bytes = {}});
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("Führung 7.alidade"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(attachment(report, QStringLiteral("Führung 7.alidade")).toUtf8());
  file.close();
  const QString printed = printedByConsole(path);
  EXPECT_TRUE(printed.contains(QStringLiteral("\"session\": \"Führung 7.alidade\"")));
  EXPECT_EQ(attachment(report, results), printed);
}

TEST(ReportResults, AreOnlyThereWhereTheConsoleHasSome) {
  Session unusable = paperSession();
  unusable.positions[0].readings[2].vertical = "85°99'00\"";
  Session half = paperSession();
  half.positions[1].readings.resize(2);
  for (const Session& session : {unusable, half}) {
    const Printed report(session);
    EXPECT_FALSE(attachments(report).contains(results));
    EXPECT_TRUE(attachments(report).contains(QStringLiteral("paper-table-1.alidade"))) << "all the same";
  }
  ReportOptions bare;
  bare.hasSession = false;
  EXPECT_FALSE(attachments(Printed(paperSession(), bare)).contains(results));
}

TEST(ReportResults, AreNotTakenForTheSession) {
  ReportSource source = Printed::savedSource();
  source.fileName = results;
  const Printed report(paperSession(), source);
  QFile file(report.path());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(*attachedSessionText(file.readAll().toStdString()), writeSession(paperSession()));
}

// The report's results include the search for suspects, although this gap was assembled without the search.
TEST(ReportResults, HoldTheSuspectsThatTheConsoleFinds) {
  const QString path = samplePath(QStringLiteral("misreading.alidade"));
  const Session session = *loadSession(path.toStdString());
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(session)));
  ASSERT_FALSE(gap.evaluation->isSearched);
  const std::string file = *readFile(path.toStdString());
  EXPECT_EQ(QString::fromStdString(*resultsJson(gap, session.title, file)), printedByConsole(path));
}

}  // namespace
}  // namespace alidade::ui
