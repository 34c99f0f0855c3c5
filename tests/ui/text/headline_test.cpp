#include "ui/text/headline.h"

#include <gtest/gtest.h>

#include "core/session/session_file.h"
#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

SharedEvaluation evaluationOf(const char* sample) {
  return std::make_shared<const Evaluation>(
      evaluateFit(*loadSession(samplePath(QString::fromLatin1(sample)).toStdString())));
}

TEST(Headline, IsTheMeasuredResultAndNamesThatOfTheFitBelow) {
  const Headline headline = headlineOf(assessGap(evaluationOf("two-causes.alidade")));
  EXPECT_EQ(headline.nameAndFigure(), QStringLiteral("Δd, measured: 0.421 ± 0.097 mm"));
  EXPECT_EQ(headline.toleranceAndVerdict(), QStringLiteral("Tolerance ± 0.5 mm · Undecided"));
  EXPECT_EQ(headline.fitOnly, QStringLiteral("Δd, fit only: 0.383 ± 0.038 mm"));
  EXPECT_TRUE(headline.isMeasured);
  EXPECT_FALSE(headline.isProvisional);
}

TEST(Headline, IsProvisionalAndOfNoVerdictWhileTheDiagnosisIsRunning) {
  for (const char* tolerance : {"2.5", "0.5", ""}) {
    Session session = paperSession();
    session.acceptance.toleranceMm = tolerance;
    const Headline headline = headlineOf(evaluateFit(session));
    EXPECT_EQ(headline.nameAndFigure(), QStringLiteral("Δd, fit only: 1.31 ± 0.21 mm"));
    EXPECT_TRUE(headline.isProvisional);
    EXPECT_FALSE(headline.isMeasured);
    EXPECT_EQ(headline.verdict.word, QStringLiteral("Provisional: the diagnosis is running."));
    EXPECT_EQ(stateOf(headline.verdict), State::Quiet) << tolerance;
  }
}

TEST(Headline, SaysPlainlyWhereThereIsNoMeasuredResult) {
  Gap gap = assessGap(evaluationOf("paper-table-1.alidade"));
  gap.diagnosis->measured.reset();
  EXPECT_EQ(headlineOf(gap).nameAndFigure(),
            QStringLiteral("Δd, measured: not determined by these readings"));
  const Headline undiagnosed = headlineOf(noGap(gap.evaluation, "Stopped."));
  EXPECT_EQ(undiagnosed.nameAndFigure(), QStringLiteral("Δd, measured: no diagnosis was made"));
  EXPECT_EQ(undiagnosed.tip, QStringLiteral("Stopped."));
  EXPECT_EQ(undiagnosed.toleranceAndVerdict(), QStringLiteral("Tolerance ± 2.5 mm · Accepted, fit only"));
  EXPECT_EQ(stateOf(undiagnosed.verdict), State::Quiet) << "the result of the fit alone is no acceptance";
  EXPECT_EQ(undiagnosed.fitOnly, QStringLiteral("Δd, fit only: 1.31 ± 0.21 mm"));
}

TEST(Headline, HasNoFigureWithoutAnIntersection) {
  Session session = paperSession();
  session.positions.pop_back();
  const Headline headline = headlineOf(evaluateFit(session));
  EXPECT_EQ(headline.nameAndFigure(), QStringLiteral("Δd, measured: —"));
  EXPECT_TRUE(headline.fitOnly.isEmpty());
  EXPECT_FALSE(headline.isProvisional);
}

TEST(Headline, StatesTheDifferenceFromTheReferenceOfTheFigureItShows) {
  const SharedEvaluation evaluation = evaluationOf("paper-table-1.alidade");
  EXPECT_EQ(headlineOf(*evaluation).reference, QStringLiteral("Reference 2.000 mm, difference −0.692 mm"));
  EXPECT_TRUE(headlineOf(assessGap(evaluation))
                  .reference.startsWith(QStringLiteral("Reference 2.000 mm, difference −0.9")));
}

TEST(Headline, SaysWhereTheToleranceIsOfTheDistance) {
  Session session = paperSession();
  session.acceptance.toleranceMm = "8";
  session.acceptance.measurand = "distance";
  EXPECT_EQ(headlineOf(evaluateFit(session)).tolerance, QStringLiteral("Tolerance of the distance d: 8 mm"));
}

}  // namespace
}  // namespace alidade::ui
