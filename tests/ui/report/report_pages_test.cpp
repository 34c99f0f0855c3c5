#include "ui/report/report_pages.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

#include "core/simulation/simulate.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

constexpr double height = 252, least = 50;

/// The number of drawings on each page, and the end of the last page.
struct Filled {
  std::vector<std::size_t> drawings;
  double end = 0;

  explicit Filled(const ReportPages& pages) : end(pages.lastEnd()) {
    for (std::size_t page = 0; page < pages.count(); ++page) drawings.push_back(pages.drawings(page).size());
  }
};

/// Pages of sections, one every `step` mm, and a last page down to `end`.
ReportPages sections(double step, double end) {
  ReportPages pages;
  double y = 0;
  for (; y + step <= height; y += step) {
    pages.mayBreak(y, ReportPages::Before::Section);
    pages.draw({});
  }
  pages.add(y);
  pages.draw({});
  pages.balance(end, least, height);
  return pages;
}

TEST(ReportPages, TakeWholeSectionsAlongWhereLittleIsLeftOver) {
  const Filled lonely(sections(40, 10));
  EXPECT_EQ(lonely.drawings, (std::vector<std::size_t>{5, 2}));
  EXPECT_DOUBLE_EQ(lonely.end, 50);
  EXPECT_EQ(Filled(sections(40, 60)).drawings, (std::vector<std::size_t>{6, 1})) << "enough is left over";
  EXPECT_EQ(Filled(sections(250, 10)).drawings, (std::vector<std::size_t>{1, 1})) << "cannot be parted";
}

TEST(ReportPages, RepeatTheHeadOfATableThatIsParted) {
  ReportPages pages;
  const auto mark = pages.mark(0);
  pages.draw({});
  const ReportPages::SharedHead head = pages.headSince(mark, 8);
  for (int row = 0; row < 48; ++row) {
    if (row >= 2) pages.mayBreak(8 + 5 * row, ReportPages::Before::Text, head);
    pages.draw({});
  }
  pages.add(8 + 5 * 48);
  const auto again = pages.mark(0);
  pages.draw({});
  pages.beginsWith(pages.headSince(again, 8));
  pages.draw({});
  pages.balance(8 + 5, least, height);
  const Filled filled(pages);
  EXPECT_EQ(filled.drawings, (std::vector<std::size_t>{1 + 48 - 8, 1 + 8 + 1}));
  EXPECT_DOUBLE_EQ(filled.end, 8 + 9 * 5);
  EXPECT_DOUBLE_EQ(pages.drawings(1)[1].lower, 8 - (8 + 5 * 40)) << "the first row stands below the head";
  EXPECT_DOUBLE_EQ(pages.drawings(1)[9].lower, 8 * 5) << "and what was on the page below the others";
}

struct Word {
  int page = 0;
  double top = 0, bottom = 0;
  QString text;
};

/// The words between head and foot, in points from the top of the page.
std::vector<Word> wordsOf(const Printed& report) {
  static const QRegularExpression line(QStringLiteral(
      "<page |<word xMin=\"[\\d.]+\" yMin=\"([\\d.]+)\" xMax=\"[\\d.]+\" yMax=\"([\\d.]+)\">(.*)</word>"));
  const QString boxes =
      report.tool(QStringLiteral("pdftotext"), {QStringLiteral("-bbox"), report.path(), QStringLiteral("-")});
  std::vector<Word> words;
  int page = -1;
  for (auto found = line.globalMatch(boxes); found.hasNext();) {
    const QRegularExpressionMatch at = found.next();
    if (at.captured(3).isEmpty()) {
      ++page;
      continue;
    }
    const Word word{page, at.captured(1).toDouble(), at.captured(2).toDouble(), at.captured(3)};
    constexpr double first = 55, last = 774;
    if (word.top >= first && word.bottom <= last) words.push_back(word);
  }
  return words;
}

Session sessionOf(int points, int rounds, std::size_t noteLength) {
  Protocol protocol = *protocolByName("paper");
  protocol.points = points;
  protocol.step = Angle::fromDegrees(160.0 / points);
  protocol.rounds = rounds;
  Session session = *simulate(protocol, drawTruth(7), 7);
  session.acceptance.toleranceMm = "2.5";
  while (session.notes.size() < noteLength) session.notes += "The air was still and the pillar dry. ";
  return session;
}

/// The last page is at least a fifth full, no page ends in a heading, and none begins with the caption of a
/// figure.
void expectNothingLonely(const Session& session, const ReportOptions& options, const std::string& what) {
  const Printed report(session, options);
  const std::vector<Word> words = wordsOf(report);
  double end = 0;
  for (const Word& word : words)
    if (word.page == report.pageCount() - 1) end = std::max(end, word.bottom);
  constexpr double top = 56.7, fifth = 252 * 72 / 25.4 / 5, line = 14;
  EXPECT_GE(end, top + fifth - line) << what << ", " << report.pageCount() << " pages";
  static const QRegularExpression heading(
      QStringLiteral("^(Findings|Notes|Method|Arcs.*|Readings with.*|Closures:.*|Gap between.*|Undetectable "
                     "here|What to measure.*|Before and after|Causes|Known.*|"
                     "Sizes that would.*|Standard uncertainty of.*|Arc centres.*|Model effects)$"));
  for (int page = 0; page < report.pageCount(); ++page) {
    const QStringList lines = report.page(page).split(u'\n', Qt::SkipEmptyParts);
    ASSERT_GE(lines.size(), 4);
    for (const QString& first : lines.mid(0, 3))
      EXPECT_FALSE(first.trimmed().startsWith(QStringLiteral("Figure"))) << what << ", page " << page + 1;
    const QString last = lines[lines.size() - 3].trimmed();  // above the two lines of the foot
    EXPECT_FALSE(heading.match(last).hasMatch())
        << what << ", page " << page + 1 << ": " << last.toStdString();
  }
}

TEST(ReportPages, LeaveNothingLonelyWhateverTheSession) {
  for (int points = 3; points <= 60; points += points < 12 ? 3 : 6)
    for (const std::size_t notes : {0u, 700u, 3500u}) {
      const Session session = sessionOf(points, 1, notes);
      ReportOptions options;
      options.gap = std::make_shared<const Gap>(
          noGap(std::make_shared<const Evaluation>(evaluate(session)), Absence::NotMade));
      const std::string what = std::to_string(points) + " points, " + std::to_string(notes) + " of notes";
      expectNothingLonely(session, options, what);
      options.paper.size = QPageSize::Letter;
      expectNothingLonely(session, options, what + ", Letter");
    }
}

// Both faces and rounds side by side make the longest captions.
TEST(ReportPages, LeaveNoCaptionWithoutItsFigure) {
  for (const char* name : {"two-faces.alidade", "dented-guideway.alidade", "paper-table-1.alidade"}) {
    const Session session = *loadSession(samplePath(QString::fromLatin1(name)).toStdString());
    ReportOptions options;
    options.gap = std::make_shared<const Gap>(
        noGap(std::make_shared<const Evaluation>(evaluate(session)), Absence::NotMade));
    for (const QPageSize::PageSizeId size : {QPageSize::A4, QPageSize::Letter}) {
      options.paper.size = size;
      expectNothingLonely(session, options, std::string(name) + (size == QPageSize::A4 ? "" : ", Letter"));
    }
  }
}

TEST(ReportPages, LeaveNothingLonelyWithADiagnosis) {
  for (const int points : {5, 9, 14, 17, 23, 31, 45}) {
    const Session session = sessionOf(points, 1, static_cast<std::size_t>(points * 40));
    ReportOptions options;
    options.gap =
        std::make_shared<const Gap>(assessGap(std::make_shared<const Evaluation>(evaluate(session))));
    for (const ReportPart part : {ReportPart::Signatures, ReportPart::Budget, ReportPart::Readings,
                                  ReportPart::Residuals, ReportPart::Method}) {
      options.contents.leftOut = {part};
      expectNothingLonely(
          session, options,
          std::to_string(points) + " points, without part " + std::to_string(static_cast<int>(part)));
    }
  }
}

}  // namespace
}  // namespace alidade::ui
