#include "ui/report/report_contents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>

#include "core/session/session_file.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/report/report_logo.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

std::set<ReportPart> everything() {
  std::set<ReportPart> parts;
  for (const ReportPartInfo& info : allReportParts()) parts.insert(info.part);
  return parts;
}

std::string textWithout(const Session& session, const std::set<ReportPart>& parts) {
  ReportOptions options;
  options.contents.leftOut = parts;
  return Printed(session, options).text().toStdString();
}

TEST(ReportContents, LeavesOutThePartsThatAreNotWantedAndSaysSo) {
  const Session session = paperSession();
  const std::pair<ReportPart, const char*> heads[] = {
      {ReportPart::Arcs, "Fitted arcs and sighted points"},
      {ReportPart::Residuals, "Residuals of the readings, observed"},
      {ReportPart::Readings, "Readings with the axis at 0°"},
      {ReportPart::Method, "rigorous orthogonal least squares"},
      {ReportPart::Budget, "Standard uncertainty of Δd, measured"},
      {ReportPart::Closures, "Closures: what must agree"},
      {ReportPart::Undetectable, "Undetectable here\n"},
      {ReportPart::Signatures, "Operator, date"}};
  const std::string whole = textWithout(session, {});
  EXPECT_THAT(whole, Not(HasSubstr("Left out")));
  for (const auto& [part, head] : heads) {
    EXPECT_THAT(whole, HasSubstr(head));
    const std::string text = textWithout(session, {part});
    EXPECT_THAT(text, Not(HasSubstr(head)));
    for (const auto& [other, otherHead] : heads)
      if (other != part) {
        EXPECT_THAT(text, HasSubstr(otherHead)) << "without " << head;
      }
    const auto info =
        std::ranges::find(allReportParts(), part, [](const ReportPartInfo& one) { return one.part; });
    EXPECT_THAT(text, HasSubstr(std::string("Left out ") + info->title));
  }
}

TEST(ReportContents, NeverLeavesOutWhatSpeaksAgainstTheResult) {
  Session session = paperSession();
  session.positions[0].readings[2].vertical = "88°71'49\"";
  session.positions[1].readings[4].excluded = true;
  session.positions[1].readings[4].note = "tripod was touched";
  const Session changed = session;
  session.positions[0].readings[5].asRead.set("vertical", "81°00'00\"");
  const std::string text = textWithout(session, everything());
  for (const char* kept : {"No verdict: 1 entry could not be used",
                           "0°, row 3 (point 3), vertical reading: ", "1 × “tripod was touched”",
                           "first entered as 81°00'00\"", "Findings", "Measurand", "Left out"})
    EXPECT_THAT(text, HasSubstr(kept));
  EXPECT_THAT(text, Not(HasSubstr("\n 1 1 1 341°52'24\""))) << "a reading of which there is nothing to tell";
  EXPECT_THAT(textWithout(paperSession(), everything()), HasSubstr("Gap between model and readings"))
      << "where they disagree";
  Session clean = *loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString());
  EXPECT_THAT(textWithout(clean, everything()), Not(HasSubstr("Gap between")));
}

TEST(ReportContents, TellsTheFormOfAGap) {
  const auto textOf = [](const char* sample) {
    const QString path = samplePath(QStringLiteral("%1.alidade").arg(QString::fromLatin1(sample)));
    return textWithout(*loadSession(path.toStdString()), everything());
  };
  const std::string text = textOf("dented-guideway");
  for (const char* said : {"Form of the gap", "The form: radius − 0.2", "The model holds where s is within",
                           "slider coordinate s (°)", "On 272 readings held out"})
    EXPECT_THAT(text, HasSubstr(said));
  EXPECT_THAT(textOf("trunnion-tilt"), Not(HasSubstr("Form of the gap")));
}

TEST(ReportContents, SaysThatTheJournalIsLeftOut) {
  Session session = paperSession();
  enterInJournal(session.journal, {.at = "2026-03-02T10:00:00Z",
                                   .by = "J. Doe",
                                   .place = "positions[0].readings[0].vertical",
                                   .from = "1",
                                   .to = "2",
                                   .why = journal_reasons::retyped});
  EXPECT_THAT(textWithout(session, {}), HasSubstr("Journal of changes"));
  const std::string text = textWithout(session, {ReportPart::Journal});
  EXPECT_THAT(text, HasSubstr("in the journal of the session, left out here"));
  EXPECT_THAT(text, HasSubstr("Left out Journal of changes"));
}

TEST(ReportContents, IsPrintedOnTheChosenPaperWithinItsMargins) {
  for (const auto size : {QPageSize::A4, QPageSize::Letter})
    for (const double margin : {ReportPaper::leastMargin, 20.0, ReportPaper::mostMargin}) {
      ReportOptions options;
      options.paper = {size, {margin, margin, margin, margin}};
      const Printed report(paperSession(), options);
      const QString boxes = report.tool(QStringLiteral("pdftotext"),
                                        {QStringLiteral("-bbox"), report.path(), QStringLiteral("-")});
      const QSizeF paper = QPageSize(size).size(QPageSize::Point);
      const double edge = margin * 72 / 25.4 - 1;
      static const QRegularExpression word(QStringLiteral(
          "<word xMin=\"([\\d.]+)\" yMin=\"([\\d.]+)\" xMax=\"([\\d.]+)\" yMax=\"([\\d.]+)\""));
      int words = 0;
      for (auto found = word.globalMatch(boxes); found.hasNext(); ++words) {
        const QRegularExpressionMatch at = found.next();
        EXPECT_GE(at.captured(1).toDouble(), edge);
        EXPECT_LE(at.captured(3).toDouble(), paper.width() - edge);
        EXPECT_GE(at.captured(2).toDouble(), 8) << "the head is on the paper";
        EXPECT_LE(at.captured(4).toDouble(), paper.height() - 8) << "and the foot";
      }
      EXPECT_GT(words, 1000);
    }
}

TEST(ReportContents, CarriesTheLogoOnItsFirstPage) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("logo.png"));
  QImage picture(3000, 900, QImage::Format_ARGB32);
  picture.fill(QColor(20, 60, 120, 128));
  ASSERT_TRUE(picture.save(path));
  ReportOptions options;
  options.logo = *readLogo(path);
  EXPECT_LE(options.logo.width(), 1400);
  EXPECT_EQ(options.logo.pixelColor(5, 5), QColor(137, 157, 187)) << "on white";
  const Printed report(paperSession(), options);
  const QStringList images =
      report.tool(QStringLiteral("pdfimages"), {QStringLiteral("-list"), report.path()})
          .split(u'\n', Qt::SkipEmptyParts);
  ASSERT_EQ(images.size(), 3) << images.join(u'\n').toStdString();
  EXPECT_TRUE(images[2].simplified().startsWith(QStringLiteral("1 0 image")));
  EXPECT_TRUE(images[2].contains(QStringLiteral(" image "))) << "nothing compressed with loss";
  EXPECT_FALSE(images[2].contains(QStringLiteral("jpeg")));
  EXPECT_TRUE(report.page(0).contains(QStringLiteral("Intersection of a rotatable arc guideway")));
}

TEST(ReportContents, RefusesALogoThatIsNone) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("logo.png"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no picture");
  file.close();
  ASSERT_FALSE(readLogo(path));
  EXPECT_THAT(readLogo(path).problem().what, HasSubstr(path.toStdString()));
  EXPECT_FALSE(readLogo(folder.path()));
}

}  // namespace
}  // namespace alidade::ui
