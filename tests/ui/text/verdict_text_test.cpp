#include "ui/text/verdict_text.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

MeasuredIntersection measuredAt(double value) {
  return {.estimate = {value, 0.1, 0.2, {{1, value, 0.1}}, std::numeric_limits<double>::infinity()},
          .budget = {{.effect = "plane_warp", .sigma = 0.1}}};
}

Evaluation evaluationAt(const char* tolerance) {
  Session session = paperSession();
  session.acceptance.toleranceMm = tolerance;
  return evaluate(session);
}

/// The verdict if the diagnosis agrees with the fit.
VerdictText verdictAt(const char* tolerance) {
  Diagnosis diagnosis;
  diagnosis.measured = measuredAt(1.308);
  return verdictText(evaluationAt(tolerance), &diagnosis);
}

TEST(VerdictText, SaysTheDecisionInAWord) {
  EXPECT_EQ(verdictAt("2.5").word, QStringLiteral("Accepted"));
  EXPECT_EQ(verdictAt("2.5").verdict, Verdict::Accept);
  EXPECT_EQ(verdictAt("1.3").word, QStringLiteral("Undecided"));
  EXPECT_EQ(verdictAt("0.5").word, QStringLiteral("Rejected"));
  EXPECT_EQ(verdictAt("0.5").verdict, Verdict::Reject);
  EXPECT_EQ(stateOf(verdictAt("2.5")), State::Good);
  EXPECT_EQ(stateOf(verdictAt("1.3")), State::Open);
  EXPECT_EQ(stateOf(verdictAt("0.5")), State::Bad);
  EXPECT_TRUE(verdictAt("0.5").sentence.contains(QStringLiteral("0.5 mm")));
}

TEST(VerdictText, HeedsTheDiagnosis) {
  Session session = paperSession();
  session.acceptance.toleranceMm = "2.5";
  const Evaluation evaluation = evaluate(session);
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::NotInCatalogue;
  diagnosis.measured = measuredAt(2.4);
  EXPECT_EQ(verdictText(evaluation, &diagnosis).word, QStringLiteral("Undecided"));
  EXPECT_TRUE(verdictText(evaluation, &diagnosis).sentence.contains(QStringLiteral("2.40 mm ± 0.20 mm")));
  diagnosis.measured->estimate.value = 2.2;
  EXPECT_EQ(verdictText(evaluation, &diagnosis).word, QStringLiteral("Accepted"));
}

TEST(VerdictText, NamesWhatBringsTheMostToU) {
  Session session = paperSession();
  session.acceptance.toleranceMm = "2.5";
  Diagnosis diagnosis;
  diagnosis.measured = measuredAt(2.4);
  const VerdictText text = verdictText(evaluate(session), &diagnosis);
  EXPECT_EQ(text.word, QStringLiteral("Undecided"));
  EXPECT_TRUE(text.sentence.contains(QStringLiteral("Most of U comes from plane warp at ")))
      << text.sentence.toStdString();
}

TEST(VerdictText, SaysThatItRestsOnTheFitOnlyWithoutADiagnosis) {
  const VerdictText text = verdictText(evaluationAt("2.5"), nullptr);
  EXPECT_EQ(text.word, QStringLiteral("Accepted, fit only"));
  EXPECT_EQ(stateOf(text), State::Quiet);
}

TEST(VerdictText, AcceptsNothingBeforeTheDiagnosis) {
  const VerdictText text = provisionalVerdict(evaluationAt("2.5"));
  EXPECT_EQ(text.word, QStringLiteral("Provisional: the diagnosis is running."));
  EXPECT_EQ(text.verdict, std::nullopt);
  EXPECT_FALSE(text.sentence.contains(QStringLiteral("probability")));
}

TEST(VerdictText, SaysWhyThereIsNone) {
  EXPECT_TRUE(verdictAt("").sentence.contains(QStringLiteral("No tolerance stated")));
  EXPECT_EQ(verdictAt("two").word, QStringLiteral("No verdict: 1 entry could not be used"));
  Session session = paperSession();
  session.positions.pop_back();
  const VerdictText verdict = verdictText(evaluate(session), nullptr);
  EXPECT_EQ(verdict.word, QStringLiteral("No result"));
  EXPECT_FALSE(verdict.sentence.isEmpty());
  EXPECT_EQ(verdict.verdict, std::nullopt);
}

}  // namespace
}  // namespace alidade::ui
