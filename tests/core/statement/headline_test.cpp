#include "core/statement/headline.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "core/effects/cause_ids.h"
#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using LineKind = Headline::Line::Kind;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

SharedEvaluation evaluationOf(const Session& session) {
  return std::make_shared<const Evaluation>(evaluateFit(session));
}

SharedEvaluation sampleEvaluation(const std::string& name) {
  return evaluationOf(*loadSession(ALIDADE_SAMPLES_DIR "/" + name));
}

MeasuredIntersection measuredAt(double value) {
  return {.estimate = {value, 0.1, 0.2, {{1, value, 0.1}}, std::numeric_limits<double>::infinity()},
          .budget = {{.effect = "plane_warp", .sigma = 0.1}}};
}

/// A gap within the noise, with this Δd.
Gap gapWith(const SharedEvaluation& evaluation, double value) {
  Gap gap = noGap(evaluation, Absence::NotMade);
  gap.diagnosis.emplace();
  gap.diagnosis->measured = measuredAt(value);
  return gap;
}

Cause causeOf(const char* effect, double probability) {
  Cause cause;
  cause.effect = effect;
  cause.probability = probability;
  return cause;
}

Session withTolerance(const char* tolerance) {
  Session session = test::paperSession();
  session.acceptance.toleranceMm = tolerance;
  return session;
}

Headline headlineAt(const char* tolerance, double value = 1.308) {
  return headlineOf(gapWith(evaluationOf(withTolerance(tolerance)), value));
}

TEST(Headline, NamesTheSealAndWarnsOfChangesSince) {
  Session session = withTolerance("2.5");
  EXPECT_EQ(headlineOf(evaluateFit(session)).line(LineKind::Seal), "");
  enterInJournal(session.journal, sealingEntry(session, "R. Roe", "2026-03-15T08:00:00Z"));
  const Headline sealed = headlineOf(gapWith(evaluationOf(session), 1.3));
  EXPECT_EQ(sealed.line(LineKind::Seal), "Sealed 2026-03-15 08:00 UTC by R. Roe");
  EXPECT_FALSE(sealed.lines.back().isWarning);
  enterInJournal(session.journal, {.place = "notes", .to = "more", .why = journal_reasons::retyped});
  const Headline changed = headlineOf(gapWith(evaluationOf(session), 1.3));
  EXPECT_THAT(changed.line(LineKind::Seal), HasSubstr("one unsealed change since"));
  EXPECT_TRUE(changed.lines.back().isWarning);
}

TEST(Headline, StatesNoFigureWhoseUncertaintyExceedsTheArc) {
  Gap gap = gapWith(evaluationOf(withTolerance("2.5")), -6363);
  gap.diagnosis->measured->estimate.expanded = 21464;
  const Headline headline = headlineOf(gap);
  EXPECT_EQ(headline.nameAndFigure(), "Δd: not determined by these readings");
  EXPECT_FALSE(headline.scale);
  EXPECT_EQ(headline.line(LineKind::Interval), "") << "nor an interval of it";
}

TEST(Headline, KeepsItsVerdictWhileARepeatIsStillToCome) {
  Session session = withTolerance("2.5");
  session.positions.push_back({.axisDeg = "0", .zero = {}, .readings = {}, .origin = {}});
  EXPECT_NE(headlineOf(gapWith(evaluationOf(session), 1.3)).decided, std::nullopt);
  session.positions.back().zero.horizontal = "332 32 54";
  const Headline begun = headlineOf(gapWith(evaluationOf(session), 1.3));
  EXPECT_EQ(begun.decided, std::nullopt) << "half a zero is an entry that cannot be used";
}

TEST(Headline, IsTheMeasuredResultAndNamesThatOfTheFitBelow) {
  const Headline headline = headlineOf(assessGap(sampleEvaluation("two-causes.alidade")));
  EXPECT_EQ(headline.nameAndFigure(), "Δd = 0.421 ± 0.096 mm");
  EXPECT_EQ(headline.verdictAndTolerance(), "Undecided · tolerance ± 0.5 mm");
  EXPECT_EQ(headline.fitOnly, "Δd, fit only: 0.383 ± 0.038 mm");
  EXPECT_TRUE(headline.isMeasured);
  EXPECT_FALSE(headline.isProvisional);
}

TEST(Headline, SaysTheDecisionInAWord) {
  EXPECT_EQ(headlineAt("2.5").verdict, "Accepted");
  EXPECT_EQ(headlineAt("2.5").decided, Verdict::Accept);
  EXPECT_EQ(headlineAt("1.3").verdict, "Undecided");
  EXPECT_EQ(headlineAt("0.5").verdict, "Rejected");
  EXPECT_EQ(headlineAt("0.5").decided, Verdict::Reject);
  EXPECT_THAT(headlineAt("0.5").sentence, HasSubstr("0.5 mm"));
}

TEST(Headline, SaysThatTheIntervalKeepsTheVerdictOpen) {
  const Headline open = headlineAt("1.3");
  EXPECT_EQ(open.line(LineKind::Interval), "The interval from 1.11 to 1.51 mm crosses the limit of 1.3 mm");
  EXPECT_EQ(open.lines.front().kind, LineKind::Interval) << "before what is said of a verdict";
  EXPECT_TRUE(open.lines.front().isWarning);
  EXPECT_EQ(headlineAt("1.3", -1.308).line(LineKind::Interval),
            "The interval from −1.51 to −1.11 mm crosses the limit of −1.3 mm");
  EXPECT_EQ(headlineAt("1.45", 1.1).line(LineKind::Interval),
            "The interval of the fit only, from 1.10 to 1.52 mm, crosses the limit of 1.45 mm");
  for (const char* decided : {"2.5", "0.5", ""}) EXPECT_EQ(headlineAt(decided).line(LineKind::Interval), "");
}

TEST(Headline, SaysThatAGapOfNoKnownCauseAloneKeepsTheVerdictOpen) {
  Gap gap = gapWith(evaluationOf(withTolerance("2.5")), 1.3);
  gap.diagnosis->verdict = DiagnosisVerdict::NotInCatalogue;
  gap.diagnosis->unexplained.chance = 0.99;
  const Headline open = headlineOf(gap);
  EXPECT_EQ(open.decided, Verdict::Undecided);
  EXPECT_THAT(open.line(LineKind::Gap), StartsWith("Undecided, whatever U is: model and readings disagree"));
  gap.diagnosis->unexplained.chance = 0.5;
  EXPECT_THAT(headlineOf(gap).line(LineKind::Gap),
              StartsWith("Model and readings disagree, and no catalogued"));
}

TEST(Headline, NamesLargerNoiseBesideACause) {
  Gap gap = gapWith(evaluationOf(withTolerance("2.5")), 1.3);
  gap.diagnosis->verdict = DiagnosisVerdict::SingleCause;
  gap.diagnosis->causes = {causeOf("plane_offset", 0.72), causeOf(noiseId, 0.9)};
  EXPECT_EQ(headlineOf(gap).line(LineKind::Gap),
            "Model and readings disagree; accepted only if the cause is plane offset (72 %), and noise "
            "larger than stated");
}

TEST(Headline, SaysWhichReadingIsMisread) {
  Gap gap = gapWith(evaluationOf(withTolerance("2.5")), 1.3);
  gap.diagnosis->verdict = DiagnosisVerdict::SingleCause;
  Cause cause = causeOf(grossErrorId, 0.9999);
  cause.readings = {{.axisDeg = 0, .point = 5, .kind = ReadingKind::Vertical, .size = 600}};
  gap.diagnosis->causes = {cause};
  EXPECT_THAT(headlineOf(gap).line(LineKind::Gap),
              HasSubstr("misread values at 0°, point 5, vertical (> 99.9 %)"));
  cause.readings.push_back(cause.readings.front());
  gap.diagnosis->causes = {cause};
  EXPECT_THAT(headlineOf(gap).line(LineKind::Gap), HasSubstr("misread values (> 99.9 %)"));
}

TEST(Headline, CallsAJumpThatWasFoundNotUndetectable) {
  Gap gap = gapWith(evaluationOf(withTolerance("0.5")), 1.3);
  gap.diagnosis->undetectable = {{.effect = jumpId, .influence = 0.4}};
  EXPECT_THAT(headlineOf(gap).line(LineKind::Undetectable), HasSubstr("jump of the orientation ± 0.40 mm"));
  gap.diagnosis->causes = {causeOf(jumpId, 0.99)};
  EXPECT_THAT(headlineOf(gap).line(LineKind::Undetectable),
              HasSubstr("a further jump of the orientation ± 0.40 mm"));
}

TEST(Headline, WarnsOfAnUndetectableEffectUnlessTheVerdictIsOpenAnyway) {
  for (const auto& [tolerance, isWarning] :
       {std::pair("2.5", true), std::pair("0.5", true), std::pair("", true), std::pair("1.3", false)}) {
    Gap gap = gapWith(evaluationOf(withTolerance(tolerance)), 1.3);
    gap.diagnosis->undetectable = {{.effect = jumpId, .influence = 0.4}};
    const Headline headline = headlineOf(gap);
    const auto line = std::ranges::find(headline.lines, LineKind::Undetectable, &Headline::Line::kind);
    ASSERT_NE(line, headline.lines.end());
    EXPECT_EQ(line->isWarning, isWarning) << headline.verdict;
  }
}

// The fit only says 1.31 ± 0.21 mm.
TEST(Headline, HeedsTheDiagnosis) {
  EXPECT_EQ(headlineAt("2.5", 2.4).verdict, "Undecided");
  EXPECT_THAT(headlineAt("2.5", 2.4).sentence, HasSubstr("2.40 mm ± 0.20 mm"));
  EXPECT_THAT(headlineAt("2.5", 2.4).sentence, HasSubstr("Most of U comes from plane warp at "));
  EXPECT_EQ(headlineAt("2.5", 2.2).verdict, "Accepted");
}

TEST(Headline, PutsTheResultOnTheScaleOfItsTolerance) {
  const Headline headline = headlineAt("2.5", -1.3);
  ASSERT_TRUE(headline.scale);
  EXPECT_DOUBLE_EQ(headline.scale->size, 1.3);
  EXPECT_DOUBLE_EQ(headline.scale->expanded, 0.2);
  EXPECT_DOUBLE_EQ(headline.scale->tolerance, 2.5);
  EXPECT_FALSE(headlineAt("").scale);
}

TEST(Headline, IsProvisionalAndOfNoVerdictWhileTheDiagnosisIsRunning) {
  for (const char* tolerance : {"2.5", "0.5", ""}) {
    const Headline headline = headlineOf(*evaluationOf(withTolerance(tolerance)));
    EXPECT_EQ(headline.nameAndFigure(), "Δd, fit only = 1.31 ± 0.21 mm");
    EXPECT_TRUE(headline.isProvisional);
    EXPECT_FALSE(headline.isMeasured);
    EXPECT_EQ(headline.verdict, "Provisional: the diagnosis is running.");
    EXPECT_EQ(headline.decided, std::nullopt) << tolerance;
    EXPECT_THAT(headline.sentence, IsEmpty());
  }
}

TEST(Headline, SaysPlainlyWhereThereIsNoMeasuredResult) {
  Gap gap = gapWith(evaluationOf(test::paperSession()), 1.3);
  gap.diagnosis->measured.reset();
  EXPECT_EQ(headlineOf(gap).nameAndFigure(), "Δd: not determined by these readings");
  const Headline undiagnosed = headlineOf(noGap(gap.evaluation, Absence::Stopped));
  EXPECT_EQ(undiagnosed.nameAndFigure(), "Δd: no diagnosis was made");
  EXPECT_EQ(undiagnosed.tip, "The diagnosis was stopped. The next edit starts it again.");
  EXPECT_EQ(undiagnosed.verdictAndTolerance(), "Accepted, fit only · tolerance ± 2.5 mm");
  EXPECT_EQ(undiagnosed.decided, std::nullopt) << "the result of the fit alone is no acceptance";
  EXPECT_EQ(undiagnosed.fitOnly, "Δd, fit only: 1.31 ± 0.21 mm");
}

TEST(Headline, HasNoFigureWithoutAnIntersection) {
  Session session = test::paperSession();
  session.positions.pop_back();
  const Headline headline = headlineOf(*evaluationOf(session));
  EXPECT_EQ(headline.nameAndFigure(), "Δd: —");
  EXPECT_EQ(headline.verdict, "No result");
  EXPECT_FALSE(headline.sentence.empty());
  EXPECT_TRUE(headline.fitOnly.empty());
  EXPECT_FALSE(headline.isProvisional);
  EXPECT_FALSE(headline.scale);
}

TEST(Headline, SaysWhyThereIsNoVerdict) {
  EXPECT_THAT(headlineAt("").sentence, HasSubstr("No tolerance is stated"));
  EXPECT_EQ(headlineAt("two").verdict, "No verdict: 1 entry could not be used");
  EXPECT_EQ(headlineAt("two").decided, std::nullopt);
}

TEST(Headline, SpeaksOfNoVerdictWithAnEntryThatCannotBeUsed) {
  Session session = withTolerance("2.5");
  session.positions[0].readings[3].vertical = "86 71 00";
  const Headline headline = headlineOf(assessGap(evaluationOf(session)));
  EXPECT_EQ(headline.verdict, "No verdict: 1 entry could not be used");
  EXPECT_TRUE(headline.isMeasured);
  EXPECT_THAT(headline.line(LineKind::Gap), StartsWith("Model and readings disagree, best explained by "));
  EXPECT_TRUE(headline.line(LineKind::Jump).empty() && headline.line(LineKind::Row).empty());
}

// The published table closes neither in R nor in Δx; the offset across the plane follows from the radii.
TEST(Headline, SaysWhatToReadBeforeTheVerdictOfThePaperIsUsed) {
  const Headline headline = headlineOf(assessGap(sampleEvaluation("paper-table-1.alidade")));
  EXPECT_EQ(headline.decided, Verdict::Accept);
  EXPECT_THAT(
      headline.line(LineKind::Across),
      ContainsRegex("^Across the plane of the arc: Δz = −[56]\\.[0-9] ± [0-9.]+ mm, not judged \\(the "
                    "tolerance is of Δd\\)$"));
  EXPECT_THAT(headline.line(LineKind::Gap), ContainsRegex("the radii differ by 1[0-9] σ"));
  ASSERT_TRUE(headline.offset);
  EXPECT_NEAR(headline.offset->across, -5.9, 0.1) << "the radii differ by 1.96 mm: Δz = ΔR/2 · L/R";
  EXPECT_EQ(headline.offset->tolerance, 2.5);
  EXPECT_THAT(headline.line(LineKind::Reference),
              ContainsRegex("^Reference 2 mm: difference −0\\.7[0-9] ± 0\\.[78][0-9] "
                            "mm, (dis)?agrees \\(E_n [01]\\.[0-9]+\\)$"));
}

// E_n is the difference over √(U² + U_ref²).
TEST(Headline, JudgesTheReferenceByBothUncertainties) {
  Session session = test::paperSession();
  session.acceptance.referenceIntersectionMm = "2";
  const auto lineAt = [&](double value) {
    return headlineOf(gapWith(evaluationOf(session), value)).line(LineKind::Reference);
  };
  EXPECT_EQ(lineAt(1.9), "Reference 2 mm: difference −0.10 ± 0.20 mm, agrees (E_n 0.50)");
  EXPECT_EQ(lineAt(2.3), "Reference 2 mm: difference 0.30 ± 0.20 mm, disagrees (E_n 1.50)");
  session.acceptance.sigmaReferenceMm = "0.3";
  EXPECT_THAT(lineAt(2.3), StartsWith("Reference 2 mm (u 0.3 mm): difference 0.30 ± 0."));
  EXPECT_THAT(lineAt(2.3), HasSubstr(", agrees ("));
}

TEST(Headline, IsTheDistanceWhereTheToleranceIsOfIt) {
  Session session = withTolerance("8");
  session.acceptance.measurand = "distance";
  Gap gap = gapWith(evaluationOf(session), 3);
  gap.diagnosis->measured->across = MeasuredLength{4, 0.3, 0.6};
  gap.diagnosis->measured->distance = MeasuredLength{5, 0.25, 0.5};
  const Headline headline = headlineOf(gap);
  EXPECT_EQ(headline.nameAndFigure(), "d = 5.00 ± 0.50 mm");
  EXPECT_EQ(headline.tolerance, "tolerance 8 mm");
  EXPECT_EQ(headline.line(LineKind::Across),
            "In the plane of the arc Δd = 3.00 ± 0.20 mm, perpendicular to it Δz = 4.00 ± 0.60 mm");
  EXPECT_DOUBLE_EQ(headline.scale->size, 5);
  EXPECT_EQ(headline.scale->name, "d ± U");
  gap.diagnosis->measured->distance.reset();
  EXPECT_EQ(headlineOf(gap).scale->name, "|Δd| ± U") << "the figure is Δd";
}

TEST(Headline, NamesTheCausesAsConditionOfTheVerdict) {
  Gap gap = gapWith(evaluationOf(test::paperSession()), 1.3);
  gap.diagnosis->verdict = DiagnosisVerdict::SeveralCauses;
  gap.diagnosis->causes = {causeOf("axial_shift", 0.17), causeOf("plane_offset", 0.72)};
  Closure radii = closureOf(Closure::Of::Radius, 1.96, 0.15, 100);
  Closure centres = closureOf(Closure::Of::Centre, 0.7, 0.1, 100);
  gap.diagnosis->closures = {{.before = radii, .after = closureOf(Closure::Of::Radius, 0.01, 0.15, 100)},
                             {.before = centres, .after = closureOf(Closure::Of::Centre, 0.01, 0.1, 100)}};
  EXPECT_EQ(headlineOf(gap).line(LineKind::Gap),
            "Model and readings disagree; accepted only if the cause is plane offset (72 %) and axial "
            "shift (17 %): the radii differ by 13 σ, "
            "Δx differs by 7.0 σ");
}

TEST(ToleranceScale, ShowsSizeIntervalAndLimitInCharacters) {
  EXPECT_EQ(scaleText({1, 0.5, 2}, 23), "0 =====[====|----]----:--  2 mm");
  EXPECT_EQ(scaleText({0.1, 0.5, 2}, 23), "0 [|----]-------------:--  2 mm") << "begins at zero";
}

}  // namespace
}  // namespace alidade
