#include "ui/dialogs/report_flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

#include "core/session/session_file.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/report/report_choice.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

class ReportFlowTest : public testing::Test {
 protected:
  ReportFlowTest() {
    forget();
    EXPECT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  }
  ~ReportFlowTest() override { forget(); }

  static void forget() { QSettings().remove(QStringLiteral("report")); }
  QString in(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
  /// Removes the parts that depend on the time and the attachments.
  static QString pagesOf(const QString& path) {
    static const QRegularExpression time(QStringLiteral("\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d"));
    return printedText(path).remove(time);
  }
  static QString infoOf(const QString& path) {
    QProcess program;
    program.start(QStringLiteral("pdfinfo"), {path});
    EXPECT_TRUE(program.waitForFinished());
    return QString::fromUtf8(program.readAllStandardOutput());
  }

  QTemporaryDir folder;
  OpenWindow open;
};

TEST_F(ReportFlowTest, PrintsAndShowsTheVeryPagesOfThePdf) {
  open.dialogs->reportPath = in("report.pdf");
  open.dialogs->printPath = in("printed.pdf");
  open.dialogs->previewPaths = QStringList{in("preview.pdf")};
  ASSERT_TRUE(open->files().exportReport());
  ASSERT_TRUE(open->files().printReport());
  ASSERT_TRUE(open->files().previewReport());
  const QString pages = pagesOf(open.dialogs->reportPath);
  EXPECT_THAT(pages.toStdString(), HasSubstr("Acceptance report"));
  EXPECT_EQ(pagesOf(open.dialogs->printPath), pages);
  EXPECT_EQ(pagesOf(open.dialogs->previewPaths[0]), pages);
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
}

TEST_F(ReportFlowTest, TellsTheHistoryOfTheDeviceWhereItsFolderIsChosen) {
  ReportChoice choice;
  choice.seriesFolder = samplePath(QStringLiteral("history"));
  open.dialogs->reportChoice = choice;
  open.dialogs->reportPath = in("another device.pdf");
  ASSERT_TRUE(open->files().exportReport());
  EXPECT_THAT(printedText(in("another device.pdf")).toStdString(),
              Not(HasSubstr("on the value is larger by 0.2")));
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("history/2025-12-15.alidade"))));
  open.dialogs->reportPath = in("report.pdf");
  ASSERT_TRUE(open->files().exportReport());
  const std::string report = printedText(in("report.pdf")).toStdString();
  EXPECT_THAT(report, HasSubstr("Acceptance report"));
  EXPECT_THAT(report, HasSubstr("on the value is larger by 0.2"));
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
}

TEST_F(ReportFlowTest, KeepsTheChoiceForTheNextReport) {
  ReportChoice choice;
  choice.contents.leftOut = {ReportPart::Readings, ReportPart::Method};
  choice.paper = {QPageSize::Letter, {25, 20, 15, 30}};
  choice.hasSession = false;
  open.dialogs->reportChoice = choice;
  open.dialogs->reportPath = in("report.pdf");
  ASSERT_TRUE(open->files().exportReport());
  EXPECT_EQ(rememberedReportChoice(), choice);
  EXPECT_THAT(infoOf(in("report.pdf")).toStdString(), HasSubstr("(letter)"));
  open.dialogs->reportChoice.reset();
  open.dialogs->printPath = in("printed.pdf");
  ASSERT_TRUE(open->files().printReport());
  EXPECT_EQ(open.dialogs->reportQuestions.back().choice, choice);
  EXPECT_EQ(pagesOf(in("printed.pdf")), pagesOf(in("report.pdf")));
  EXPECT_THAT(infoOf(in("printed.pdf")).toStdString(), HasSubstr("(letter)"));
}

TEST_F(ReportFlowTest, GoesFromThePreviewToContentsPageAndPrinter) {
  open.dialogs->previewPaths = QStringList{in("1.pdf"), in("2.pdf"), in("3.pdf")};
  open.dialogs->previewAnswers = {PreviewAnswer::Contents, PreviewAnswer::Page, PreviewAnswer::Print};
  ReportChoice choice;
  choice.contents.leftOut = {ReportPart::Readings};
  open.dialogs->reportChoice = choice;
  open.dialogs->paper = ReportPaper{QPageSize::Letter, {20, 20, 20, 25}};
  open.dialogs->printPath = in("printed.pdf");
  ASSERT_TRUE(open->files().previewReport());
  EXPECT_EQ(open.dialogs->previews, 3);
  const std::string readings = "Readings with the axis at 0°";
  EXPECT_THAT(printedText(in("1.pdf")).toStdString(), HasSubstr(readings));
  EXPECT_THAT(printedText(in("2.pdf")).toStdString(), testing::Not(HasSubstr(readings)));
  EXPECT_THAT(infoOf(in("2.pdf")).toStdString(), HasSubstr("(A4)"));
  EXPECT_THAT(infoOf(in("3.pdf")).toStdString(), HasSubstr("(letter)"));
  EXPECT_TRUE(QFile::exists(in("printed.pdf")));
}

TEST_F(ReportFlowTest, NothingIsPrintedOrWrittenWhereItIsCancelled) {
  open.dialogs->writeAnyway = false;
  open.dialogs->reportPath = in("report.pdf");
  EXPECT_FALSE(open->files().exportReport());
  EXPECT_FALSE(open->files().printReport());
  open.dialogs->writeAnyway = true;
  EXPECT_FALSE(open->files().printReport()) << "no printer";
  EXPECT_FALSE(QFile::exists(in("report.pdf")));
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
}

TEST_F(ReportFlowTest, NamesALogoThatIsGone) {
  ReportChoice choice;
  choice.logoPath = in("logo.png");
  open.dialogs->reportChoice = choice;
  open.dialogs->reportPath = in("report.pdf");
  EXPECT_FALSE(open->files().exportReport());
  ASSERT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_THAT(open.dialogs->problems[0].toStdString(), HasSubstr("logo.png"));
  QImage logo(300, 100, QImage::Format_RGB32);
  logo.fill(Qt::darkGreen);
  ASSERT_TRUE(logo.save(choice.logoPath));
  EXPECT_TRUE(open->files().exportReport());
}

TEST_F(ReportFlowTest, OpensTheSessionOutOfTheReport) {
  const Session session = open->document().session();
  open.dialogs->reportPath = in("report.pdf");
  ASSERT_TRUE(open->files().exportReport());
  const QByteArray before = [&] {
    QFile file(in("report.pdf"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }();
  ASSERT_TRUE(open->files().startNew());
  ASSERT_TRUE(open->files().open(in("report.pdf")));
  EXPECT_EQ(open->document().session(), session);
  EXPECT_EQ(open->document().path(), QString()) << "saving must not overwrite the report";
  EXPECT_FALSE(open->document().isModified());
  open.dialogs->savePath = in("again.alidade");
  ASSERT_TRUE(open->files().save());
  QFile saved(in("again.alidade")), sample(samplePath(QStringLiteral("paper-table-1.alidade")));
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly) && sample.open(QIODevice::ReadOnly));
  EXPECT_EQ(*readSession(saved.readAll().toStdString()), *readSession(sample.readAll().toStdString()));
  QFile report(in("report.pdf"));
  ASSERT_TRUE(report.open(QIODevice::ReadOnly));
  EXPECT_EQ(report.readAll(), before);
}

// Readings from a report count as recorded: changing them adds an entry to the journal.
TEST_F(ReportFlowTest, WhatIsOpenedOutOfAReportStands) {
  open.dialogs->reportPath = in("report.pdf");
  ASSERT_TRUE(open->files().exportReport());
  ASSERT_TRUE(open->files().open(in("report.pdf")));
  ReadingsEditor(open->document(), 0).setCell({3, ReadingColumn::Vertical}, "80°00'00\"");
  changeField(open->document(), {.field = "geometry.distance_mm"}, "2406");
  EXPECT_EQ(open->document().session().journal.size(), 2u);
}

// Attaches the current session rather than the saved one.
TEST_F(ReportFlowTest, AttachesUnsavedChangesToo) {
  changeField(open->document(), {.field = "title"}, "changed since");
  open.dialogs->reportPath = in("report.pdf");
  ASSERT_TRUE(open->files().exportReport());
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  ASSERT_TRUE(open->files().open(in("report.pdf")));
  EXPECT_EQ(open->document().session().title, "changed since");
}

TEST_F(ReportFlowTest, SaysInASentenceWhyAPdfCannotBeOpened) {
  const Session before = open->document().session();
  ReportChoice choice;
  choice.hasSession = false;
  open.dialogs->reportChoice = choice;
  open.dialogs->reportPath = in("bare.pdf");
  ASSERT_TRUE(open->files().exportReport());
  EXPECT_FALSE(open->files().open(in("bare.pdf")));
  EXPECT_THAT(open.dialogs->problems.takeLast().toStdString(), HasSubstr("No session is attached"));
  QFile torn(in("torn.pdf"));
  ASSERT_TRUE(torn.open(QIODevice::WriteOnly));
  torn.write("%PDF-1.7\nnothing more");
  torn.close();
  EXPECT_FALSE(open->files().open(in("torn.pdf")));
  EXPECT_THAT(open.dialogs->problems.takeLast().toStdString(), HasSubstr("The PDF cannot be read"));
  EXPECT_EQ(open->document().session(), before);
}

}  // namespace
}  // namespace alidade::ui
