#include <gtest/gtest.h>

#include <QFile>
#include <QSet>
#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>
#include <vector>

#include "core/evaluation/evaluation.h"
#include "tests/ui/language/speaking.h"
#include "tests/ui/support.h"
#include "ui/dialogs/report_flow.h"
#include "ui/document/session_document.h"
#include "ui/report/report_choice.h"

namespace alidade::ui {
namespace {

/// Records the waiting dialogs.
class WatchedDialogs : public ScriptedDialogs {
 public:
  std::unique_ptr<Busy> busy(const QString& doing, Busy::Way way) override {
    // The sentence is in the current language of the window.
    if (doing == ReportFlow::tr("Fitting and diagnosing for the report…")) ++diagnoses;
    return ScriptedDialogs::busy(doing, way);
  }

  int diagnoses = 0;
};

class ReportLanguageTest : public testing::Test {
 protected:
  ReportLanguageTest() {
    forget();
    EXPECT_FALSE(document.load(samplePath(QStringLiteral("paper-table-1.alidade"))));
    dialogs.reportPath = folder.filePath(QStringLiteral("report.pdf"));
  }
  ~ReportLanguageTest() override { forget(); }

  static void forget() { QSettings().remove(QStringLiteral("report")); }
  void choose(const char* language) {
    ReportChoice choice;
    choice.language = QString::fromLatin1(language);
    dialogs.reportChoice = choice;
  }

  QTemporaryDir folder;
  WatchedDialogs dialogs;
  SessionDocument document;
  ReportFlow flow{document, dialogs};
};

TEST_F(ReportLanguageTest, OfTheWindowTakesWhatWasDiagnosedForTheQuestion) {
  choose("");
  ASSERT_TRUE(flow.exportPdf({}));
  EXPECT_EQ(dialogs.diagnoses, 1);
}

// A diagnosis contains sentences in one language, so a report in another language needs its own diagnosis.
TEST_F(ReportLanguageTest, OtherThanTheWindowsIsDiagnosedInAndRemembered) {
  choose("zh_CN");
  ASSERT_TRUE(flow.exportPdf({}));
  EXPECT_EQ(dialogs.diagnoses, 2);
  EXPECT_TRUE(QFile::exists(dialogs.reportPath));
  EXPECT_EQ(rememberedReportChoice().language, QStringLiteral("zh_CN"));
}

TEST_F(ReportLanguageTest, IsDiagnosedInOnceForPreviewAndPrint) {
  choose("zh_CN");
  rememberReportChoice(*dialogs.reportChoice);
  dialogs.previewPaths =
      QStringList{folder.filePath(QStringLiteral("1.pdf")), folder.filePath(QStringLiteral("2.pdf"))};
  dialogs.previewAnswers = {PreviewAnswer::Page, PreviewAnswer::Print};
  dialogs.printPath = folder.filePath(QStringLiteral("printed.pdf"));
  ASSERT_TRUE(flow.preview({}));
  EXPECT_EQ(dialogs.previews, 2);
  EXPECT_TRUE(QFile::exists(dialogs.printPath));
  EXPECT_EQ(dialogs.diagnoses, 2);
  ASSERT_TRUE(flow.print()) << "anew for the next report: the session may be another";
  EXPECT_EQ(dialogs.diagnoses, 4);
}

TEST_F(ReportLanguageTest, ThatTheWindowSpeaksIsNotDiagnosedInAgain) {
  choose("en");
  ASSERT_TRUE(flow.exportPdf({}));
  EXPECT_EQ(dialogs.diagnoses, 1);
  const Speaking speaking(QStringLiteral("zh_CN"));
  ASSERT_TRUE(flow.exportPdf({}));
  EXPECT_EQ(dialogs.diagnoses, 3);
}

// The window stays responsive while a report is written, and keeps its language.
TEST_F(ReportLanguageTest, IsNotThatOfTheWindowMeanwhile) {
  QSet<QString> heard;
  std::vector<double> progress;
  ReportOptions options;
  options.language = QStringLiteral("zh_CN");
  options.goesOn = [&](double done) {
    heard.insert(shownLanguage());
    progress.push_back(done);
    return true;
  };
  ASSERT_TRUE(writeAcceptanceReport(evaluate(document.session()), {}, dialogs.reportPath, options));
  EXPECT_EQ(heard, QSet<QString>{QStringLiteral("en")});
  EXPECT_EQ(shownLanguage(), QStringLiteral("en"));
  EXPECT_GT(progress.size(), 34u) << "a step for each row and each page";
  EXPECT_TRUE(std::ranges::is_sorted(progress)) << "the second position does not begin at the start";
  EXPECT_GT(progress.back(), 0.5) << "the pages are painted after all is laid out";
}

}  // namespace
}  // namespace alidade::ui
