#include "ui/report/report_verdict.h"

#include <gtest/gtest.h>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

ReportVerdict verdictAt(const char* tolerance) {
  Session session = paperSession();
  session.acceptance.toleranceMm = tolerance;
  return reportVerdict(evaluate(session));
}

TEST(ReportVerdict, SaysTheDecisionInAWord) {
  EXPECT_EQ(verdictAt("2.5").word, QStringLiteral("Accepted"));
  EXPECT_TRUE(verdictAt("2.5").isAccepted);
  EXPECT_EQ(verdictAt("1.3").word, QStringLiteral("Undecided"));
  EXPECT_EQ(verdictAt("0.5").word, QStringLiteral("Rejected"));
  EXPECT_FALSE(verdictAt("0.5").isAccepted);
  EXPECT_TRUE(verdictAt("0.5").sentence.contains(QStringLiteral("0.5 mm")));
}

TEST(ReportVerdict, SaysWhyThereIsNone) {
  EXPECT_TRUE(verdictAt("").sentence.contains(QStringLiteral("No tolerance stated")));
  EXPECT_EQ(verdictAt("two").word, QStringLiteral("No verdict: 1 entry could not be used"));
  Session session = paperSession();
  session.positions.pop_back();
  const ReportVerdict verdict = reportVerdict(evaluate(session));
  EXPECT_EQ(verdict.word, QStringLiteral("No result"));
  EXPECT_FALSE(verdict.sentence.isEmpty());
  EXPECT_FALSE(verdict.isAccepted);
}

}  // namespace
}  // namespace alidade::ui
