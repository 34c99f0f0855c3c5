#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/base/number_text.h"
#include "core/diagnosis/diagnose.h"
#include "core/session/session_file.h"
#include "core/statement/gap.h"
#include "core/statement/next_measures.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Kind = GapStage::Kind;

/// The diagnosed gap of a session; with the effects of a model.
const Gap& gapOfFile(const std::string& file, const std::vector<std::string>& effects = {}) {
  static std::map<std::pair<std::string, std::vector<std::string>>, Gap>
      gaps;  // a diagnosis takes half a second
  const auto key = std::pair(file, effects);
  if (const auto known = gaps.find(key); known != gaps.end()) return known->second;
  Session session = *loadSession(file);
  session.model.effects = effects;
  return gaps[key] = assessGap(std::make_shared<const Evaluation>(evaluateFit(std::move(session))));
}

const Gap& sampleGap(const std::string& name, const std::vector<std::string>& effects = {}) {
  return gapOfFile(ALIDADE_SAMPLES_DIR "/" + name + ".alidade", effects);
}

/// A gap of the paper's session without a real diagnosis.
Gap emptyGap() {
  Gap gap = noGap(std::make_shared<const Evaluation>(evaluateFit(test::paperSession())), Absence::NotMade);
  gap.diagnosis.emplace();
  gap.stages.emplace_back();
  return gap;
}

std::string cellOf(const Statement& statement, std::size_t row, const std::string& id) {
  for (std::size_t i = 0; i < statement.columns.size(); ++i)
    if (statement.columns[i].id == id) return statement.rows.at(row).cells.at(i);
  return "no such column";
}

std::vector<std::string> namesOf(const Statement& statement) {
  std::vector<std::string> names;
  for (const Statement::Row& row : statement.rows) names.push_back(row.cells.front());
  return names;
}

std::string allTexts(const Statement& statement) {
  std::string texts = statement.title + "\n" + statement.note + "\n";
  for (const auto& column : statement.columns) texts += column.title + "\n";
  for (const auto& row : statement.rows)
    for (const std::string& text : row.cells) texts += text + "\n";
  for (const std::string& sentence : statement.sentences) texts += sentence + "\n";
  return texts;
}

TEST(GapStatements, FillEveryColumnAndNameNoIdentifier) {
  for (const char* sample : {"trunnion-tilt", "knocked-tripod", "dented-guideway", "two-causes",
                             "clean-session", "paper-table-1", "unknown-form"}) {
    const Gap& gap = sampleGap(sample);
    ASSERT_TRUE(gap.diagnosis) << sample;
    for (const Statement& statement :
         {gapVerdict(gap), gapCauses(gap), gapForms(gap), gapStages(gap), gapClosures(gap), gapRequired(gap),
          gapUndetectable(gap), gapAdvice(gap), gapKnown(gap)}) {
      for (const Statement::Row& row : statement.rows)
        EXPECT_EQ(row.cells.size(), statement.columns.size()) << sample << " " << statement.id;
      EXPECT_THAT(allTexts(statement), Not(HasSubstr("_"))) << sample << " " << statement.id;
    }
  }
}

TEST(CausesStatement, TellsHowFarACauseShrinksTheResiduals) {
  const Gap& gap = sampleGap("trunnion-tilt");
  const Statement causes = gapCauses(gap);
  ASSERT_FALSE(causes.rows.empty());
  const GapStep& step = gap.diagnosis->steps.at(0);
  EXPECT_EQ(causes.rows[0].id, "trunnion_tilt");
  EXPECT_EQ(cellOf(causes, 0, "cause"), "Trunnion tilt");
  EXPECT_THAT(cellOf(causes, 0, "size"), testing::MatchesRegex("[0-9.]+ ± [0-9.]+″"));
  EXPECT_EQ(cellOf(causes, 0, "shrinks"), "residuals " + displayText(gap.diagnosis->gap.rms, 1) + "″ → " +
                                              displayText(step.size.rms, 1) + "″");
  ASSERT_TRUE(causes.rows[0].bar);
  EXPECT_DOUBLE_EQ(*causes.rows[0].bar, 1 - step.size.rms / gap.diagnosis->gap.rms);
  EXPECT_FALSE(causes.rows[0].about.empty());
}

TEST(CausesStatement, TellsWhichClosureACauseCloses) {
  const Gap& gap = sampleGap("paper-table-1");
  const Statement causes = gapCauses(gap);
  const auto closing = std::ranges::find_if(
      causes.rows, [](const Statement::Row& row) { return row.cells[3].starts_with("closes "); });
  ASSERT_NE(closing, causes.rows.end());
  EXPECT_THAT(closing->cells[3], HasSubstr(" σ → "));
  EXPECT_GT(closing->bar.value(), 0.5);
}

TEST(CausesStatement, GivesAFormItsAmplitudeAndShape) {
  const Gap& gap = sampleGap("dented-guideway");
  const Statement causes = gapCauses(gap);
  const auto form = std::ranges::find_if(
      causes.rows, [](const Statement::Row& row) { return row.cells[0].starts_with("Form: radius"); });
  ASSERT_NE(form, causes.rows.end());
  EXPECT_THAT(form->cells[1], testing::ContainsRegex(" ± .* mm"));
  EXPECT_TRUE(form->id.empty()) << "no effect of the model";
  EXPECT_GT(form->bar.value(), 0.5);
  EXPECT_TRUE(std::next(form)->isPart);
  EXPECT_EQ(std::next(form)->cells[0], "at");
  EXPECT_THAT(std::next(form)->cells[1], testing::EndsWith("°"));
  EXPECT_THAT(gapForms(gap).sentences.front(), StartsWith("The form: radius − 0.2"));
}

TEST(CausesStatement, ListsTheEffectsOfTheModel) {
  const Statement causes = gapCauses(sampleGap("trunnion-tilt", {"trunnion_tilt"}));
  ASSERT_EQ(namesOf(causes), std::vector<std::string>{"Trunnion tilt"});
  EXPECT_EQ(cellOf(causes, 0, "probability"), "in the model");
  EXPECT_THAT(cellOf(causes, 0, "shrinks"), StartsWith("residuals "));
}

TEST(CausesStatement, TellsEachMisreadValueBelowItsCause) {
  Gap gap = emptyGap();
  gap.diagnosis->causes.push_back({.effect = "gross_error",
                                   .probability = 1,
                                   .parameters = {},
                                   .indistinguishableFrom = {"orientation_jump"},
                                   .readings = {{.point = 11, .size = 29.06}, {.face = 2, .size = -3}}});
  const Statement causes = gapCauses(gap);
  EXPECT_EQ(namesOf(causes), (std::vector<std::string>{"Misread values", "0°, point 11, horizontal",
                                                       "0°, point 0, horizontal, face 2"}));
  EXPECT_EQ(cellOf(causes, 1, "size"), "+29.1″");
  EXPECT_EQ(cellOf(causes, 2, "size"), "−3.0″");
  EXPECT_EQ(cellOf(causes, 0, "look_alikes"), "a jump of the orientation");
  EXPECT_EQ(causes.textsBelow(causes.rows[0]),
            std::vector<std::string>{"indistinguishable: a jump of the orientation"});
}

TEST(StagesStatement, CountsTheMisreadValuesThatAreLeftOut) {
  Gap gap = emptyGap();
  gap.stages = {{}, {.kind = Kind::Proposed, .effect = "gross_error", .intersection = {}}};
  EXPECT_EQ(namesOf(gapStages(gap)),
            (std::vector<std::string>{"fit only", "without the misread value", "measured"}));
  gap.stages.push_back({.kind = Kind::Proposed, .effect = "collimation", .intersection = {}});
  gap.stages.push_back({.kind = Kind::Proposed, .effect = "gross_error", .intersection = {}});
  EXPECT_EQ(namesOf(gapStages(gap)),
            (std::vector<std::string>{"fit only", "without 1 misread value", "+ collimation",
                                      "without 2 misread values", "measured"}));
  gap.stages = {{}, {.kind = Kind::Proposed, .effect = "gross_error", .grossErrors = 3, .intersection = {}}};
  EXPECT_EQ(cellOf(gapStages(gap), 1, "stage"), "without 3 misread values");
}

TEST(ClosuresStatement, StatesUAtTheCoverageAndTheSizeInSigma) {
  Gap gap = emptyGap();
  gap.diagnosis->closures = {{{.of = Closure::Of::Radius, .value = 1.96, .sigma = 0.28, .chance = 1e-9}}};
  const Statement closures = gapClosures(gap);
  EXPECT_EQ(cellOf(closures, 0, "misclosure"), "1.96 ± 0.55 mm");
  EXPECT_EQ(cellOf(closures, 0, "sigmas"), "7.0 σ");
  EXPECT_TRUE(closures.rows[0].isNotable);
  EXPECT_THAT(closures.sentences.front(), StartsWith("The positions do not agree"));
}

TEST(RequiredStatement, WritesEachSizeWithItsUnitAndNeverCallsItNothing) {
  Gap gap = emptyGap();
  gap.diagnosis->whatItWouldTake = {
      {.effect = "plane_offset", .size = -5.84, .unit = "mm", .plausibleSizes = 2.44},
      {.effect = "trunnion_tilt", .size = 123.4, .unit = "arcsec", .plausibleSizes = 0.1},
      {.effect = "scale", .size = 0.00123, .unit = "1", .plausibleSizes = 0.03}};
  const Statement required = gapRequired(gap);
  EXPECT_EQ(cellOf(required, 0, "size"), "−5.8 mm");
  EXPECT_EQ(cellOf(required, 1, "size"), "123″");
  EXPECT_EQ(cellOf(required, 2, "size"), "0.0012");
  EXPECT_EQ(cellOf(required, 0, "plausible_sizes"), "2.4");
  EXPECT_EQ(cellOf(required, 1, "plausible_sizes"), "0.1");
  EXPECT_EQ(cellOf(required, 2, "plausible_sizes"), "< 0.1");
}

Advice advice(std::vector<Measure> measures, double oneLeft) {
  return {.measures = std::move(measures),
          .separates = {"collimation", "refraction"},
          .bySigma = 5,
          .oneLeft = oneLeft};
}

std::vector<std::vector<Measure>> measuresOf(std::vector<Advice> advice,
                                             std::vector<AttainableUncertainty> attainable = {}) {
  Gap gap;
  gap.diagnosis = Diagnosis{};
  gap.diagnosis->advice = std::move(advice);
  gap.diagnosis->attainable = std::move(attainable);
  return measuresNext(gap);
}

// 0.6 for half a session and for 1.2, 0.9 for two and for two: the dearer tell no more than the cheaper.
TEST(AdviceStatement, KeepsWhatNothingBeatsInBothEffortAndWhatItTells) {
  EXPECT_THAT(measuresOf({advice({Measure::BothFaces}, 0.9), advice({Measure::ShiftedCircle}, 0.6),
                          advice({Measure::At0Again}, 0.6), advice({Measure::SecondStandOff}, 0.9)}),
              ElementsAre(ElementsAre(Measure::At0Again), ElementsAre(Measure::BothFaces)));
}

// 0.2/0.1, 0.3/0.5, 0.85/1.2 and 0.95/2 of one answer for each session of effort.
TEST(AdviceStatement, NamesThreeAtMost) {
  EXPECT_THAT(measuresOf({advice({Measure::ZeroSightedAgain}, 0.2), advice({Measure::At0Again}, 0.3),
                          advice({Measure::ShiftedCircle}, 0.85), advice({Measure::SecondStandOff}, 0.95)}),
              ElementsAre(ElementsAre(Measure::ZeroSightedAgain), ElementsAre(Measure::ShiftedCircle),
                          ElementsAre(Measure::SecondStandOff)))
      << "the last tells most";
}

// −ln(0.5) = 0.69 for two sessions, and half of 0.2 for half a session: 0.35 and 0.2 for each session.
TEST(AdviceStatement, CountsWhatReducesUAlso) {
  EXPECT_THAT(
      measuresOf({advice({Measure::At0Again}, 0.2)}, {{.expanded = 0.2},
                                                      {.measures = {Measure::BothFaces}, .expanded = 0.1},
                                                      {.known = "plane_warp", .expanded = 0.05}}),
      ElementsAre(ElementsAre(Measure::BothFaces), ElementsAre(Measure::At0Again)));
}

TEST(AdviceStatement, TellsTheRowsOfTheEffort) {
  Gap gap = emptyGap();
  gap.diagnosis->advice = {advice({Measure::BothFaces}, 0.9)};
  const Statement next = gapAdvice(gap);
  ASSERT_EQ(next.rows.size(), 1u);
  EXPECT_EQ(cellOf(next, 0, "rows"), std::to_string(2 * gap.evaluation->examined.measurement->rows));
  EXPECT_EQ(cellOf(next, 0, "measures"), "Both faces (in a new session)");
  EXPECT_EQ(cellOf(next, 0, "expanded"), "") << "it would not reduce U";
  EXPECT_EQ(
      cellOf(next, 0, "tells"),
      "separates collimation and refraction by 5.0 σ or more; probability that only one cause remains: 90 %");
}

TEST(UndetectableStatement, SaysSoIfThereIsNone) {
  Gap gap = emptyGap();
  EXPECT_THAT(gapUndetectable(gap).sentences.front(), StartsWith("An effect of plausible size"));
  gap.diagnosis->before = IntersectionEstimate{.expanded = 1};
  gap.diagnosis->undetectable = {{"trunnion_tilt", 0.25, 0.5}, {"collimation", 0.001, 0.5}};
  const Statement undetectable = gapUndetectable(gap);
  EXPECT_EQ(namesOf(undetectable), std::vector<std::string>{"Trunnion tilt"})
      << "the other moves Δd by U/1000";
  EXPECT_EQ(cellOf(undetectable, 0, "influence"), "± 0.25");
}

TEST(KnownStatement, ComparesWhatIsKnownWithTheReadings) {
  Session session = test::paperSession();
  session.instrument.known = {
      {.effect = "collimation", .value = "3.2", .sigma = "0.5", .unit = "arcsec", .from = "check"}};
  session.device.known = {
      {.effect = "plane_tilt", .parameter = "tilt about x", .value = "0.1", .sigma = "0.02", .unit = "deg"}};
  const Statement known =
      gapKnown(noGap(std::make_shared<const Evaluation>(evaluateFit(session)), Absence::NotMade));
  ASSERT_EQ(known.rows.size(), 2u);
  EXPECT_EQ(known.rows[0].id, "collimation");
  EXPECT_EQ(cellOf(known, 1, "number"), "Plane tilt, tilt about x");
  EXPECT_EQ(cellOf(known, 0, "known"), "3.20″ (u 0.50)");
  EXPECT_EQ(cellOf(known, 0, "readings"), "—") << "not diagnosed";
  EXPECT_EQ(cellOf(known, 0, "from"), "check");
  EXPECT_TRUE(gapKnown(emptyGap()).rows.empty());
}

TEST(VerdictOfGap, HasAReasonWithoutADiagnosis) {
  Gap gap = emptyGap();
  gap.diagnosis.reset();
  gap.reason = Absence::NothingToCompare;
  EXPECT_THAT(reasonForNone(gap), StartsWith("There is nothing to compare yet"));
  gap.reason = FailedWork{.work = "fit", .reason = "out of memory", .record = "/x", .isRecorded = true};
  EXPECT_EQ(reasonForNone(gap),
            "The fit failed: out of memory. Nothing typed is lost; save the session and go on. A description "
            "of the "
            "fault is in /x.");
  gap.reason = DiagnosisFault(UnknownCause{"gremlins"});
  EXPECT_THAT(reasonForNone(gap), HasSubstr("“gremlins”"));
}

}  // namespace
}  // namespace alidade
