#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <map>
#include <stdexcept>

#include "core/diagnosis/diagnose.h"
#include "core/effects/cause_ids.h"
#include "core/session/session_file.h"
#include "core/statement/gap.h"
#include "core/statement/headline.h"
#include "core/wording/size_text.h"
#include "tests/ui/support.h"
#include "ui/charts/gap/closure_bars.h"
#include "ui/charts/gap/gap_map.h"
#include "ui/commands/change_session.h"
#include "ui/jobs/trial_job.h"
#include "ui/main_window.h"
#include "ui/panels/gap/gap_panel.h"
#include "ui/panels/gap/remedy_list.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Ids = std::vector<std::string>;

// Sessions of an independent ray tracer; its truth.json has the simulated effects.
const char *collimationTrial = "241926", *misreadTrial = "251468", *jumpTrial = "358092",
           *noiseTrial = "573871", *harmonicTrial = "159128", *lobingAndDriftTrial = "629105",
           *cleanTrial = "827247", *relationTrial = "987447", *sagTrial = "117223", *tiltTrial = "878035";

QString trialPath(const char* name) {
  return QStringLiteral(ALIDADE_REFERENCE_DIR "/trials/sessions/%1.alidade").arg(QString::fromLatin1(name));
}

/// A window with a session and the page Gap in front.
struct GapBench {
  explicit GapBench(const QString& path) {
    if (!open->files().open(path)) throw std::runtime_error("cannot open " + path.toStdString());
    QTest::keyClick(open.window.get(), Qt::Key_5, Qt::ControlModifier);
    waitUntilIdle();
  }
  explicit GapBench(const char* trial) : GapBench(trialPath(trial)) {}

  void waitUntilIdle() {
    open.waitUntilIdle();
    if (!waitFor([this] { return open->gapJob().isIdle(); })) throw std::runtime_error("no diagnosis");
    QCoreApplication::processEvents();
  }
  GapPanel* page() { return open->findChild<GapPanel*>(); }
  const Ids& effects() { return open->document().session().model.effects; }
  QPushButton* button(const char* name) {
    auto* found = page()->findChild<QPushButton*>(QString::fromLatin1(name));
    return found && found->isVisibleTo(page()) ? found : nullptr;
  }
  void press(const char* name) {
    QPushButton* found = button(name);
    ASSERT_TRUE(found) << name;
    ASSERT_TRUE(found->isEnabled()) << name;
    found->setFocus();
    QTest::keyClick(found, Qt::Key_Space);
    waitUntilIdle();
  }
  std::string shown() {
    QString texts;
    for (const QLabel* label : page()->findChildren<QLabel*>())
      if (label->isVisibleTo(page())) texts += label->text() + QLatin1Char('\n');
    return texts.toStdString();
  }
  QCheckBox* tick(const char* effect) { return page()->findChild<QCheckBox*>(QString::fromLatin1(effect)); }
  std::string map() { return page()->findChild<GapMap*>()->accessibleDescription().toStdString(); }
  std::string closures() { return page()->findChild<ClosureBars*>()->accessibleDescription().toStdString(); }
  DataTable* candidates() { return page()->findChild<DataTable*>(); }
  QString candidate(int row, int column) {
    return candidates()->model()->index(row, column).data().toString();
  }
  QLabel* hint() { return open->findChild<QLabel*>(QStringLiteral("gap hint")); }

  OpenWindow open;
};

struct Expected {
  const char* trial;
  const char* headline;
};

class GapVerdict : public testing::TestWithParam<Expected> {};

TEST_P(GapVerdict, IsTheTruthOfTheTrial) {
  GapBench bench(GetParam().trial);
  EXPECT_THAT(bench.shown(), HasSubstr(std::string(GetParam().headline) + "\n"));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("_"))) << "names, not ids";
}

INSTANTIATE_TEST_SUITE_P(Trials, GapVerdict,
                         testing::Values(Expected{sagTrial, "One cause: gravity sag"},
                                         Expected{collimationTrial, "One of 2 causes indistinguishable here"},
                                         Expected{misreadTrial, "One cause: misread values"},
                                         Expected{jumpTrial, "One cause: a jump of the orientation"},
                                         Expected{noiseTrial, "One cause: noise larger than stated"},
                                         Expected{harmonicTrial, "A gap of no known cause"},
                                         Expected{lobingAndDriftTrial, "2 causes"},
                                         Expected{cleanTrial, "No gap: within the noise"},
                                         Expected{relationTrial, "One cause: the vertical angle relation"}),
                         [](const auto& test) { return "Of" + std::string(test.param.trial); });

TEST(Gap, TellsAnUnknownCauseBesideKnownOnes) {
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::NotInCatalogue;
  const Cause drift{
      .effect = "vertical_drift", .parameters = {}, .indistinguishableFrom = {}, .readings = {}};
  diagnosis.causes = {drift};
  EXPECT_EQ(gapHeadline(diagnosis).toStdString(), "An unknown cause and vertical drift");
  diagnosis.causes.push_back(drift);
  EXPECT_EQ(gapHeadline(diagnosis).toStdString(), "An unknown cause and 2 known ones");
}

TEST(Gap, ShowsWhatTheDiagnosisSays) {
  GapBench bench(lobingAndDriftTrial);
  const Diagnosis diagnosis = *diagnose(*examine(bench.open->document().session()).measurement);
  ASSERT_EQ(diagnosis.causes.size(), 2u);
  const Gap gap =
      assessGap(std::make_shared<const Evaluation>(evaluateFit(bench.open->document().session())));
  for (const Statement& statement : {gapCauses(gap), gapStages(gap), gapAdvice(gap), gapUndetectable(gap)}) {
    EXPECT_THAT(bench.shown(), HasSubstr(statement.title)) << statement.id;
    EXPECT_THAT(bench.shown(), HasSubstr(statement.note)) << statement.id;
    for (const Statement::Row& row : statement.rows) {
      for (const std::string& below : statement.textsBelow(row)) EXPECT_THAT(bench.shown(), HasSubstr(below));
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        EXPECT_THAT(bench.shown(), HasSubstr(row.cells[i])) << statement.id;
    }
  }
  ASSERT_EQ(bench.candidates()->model()->rowCount(), static_cast<int>(diagnosis.candidates.size()));
  EXPECT_EQ(bench.candidate(0, 0), causeTitle(diagnosis.candidates[0].effect));
  EXPECT_EQ(bench.candidate(0, 1), numberText(diagnosis.candidates[0].logBayesFactor, 1));
  EXPECT_THAT(bench.map(), HasSubstr("belongs to: "));
  EXPECT_THAT(bench.map(), HasSubstr("along the arc: 0…30° "));
}

TEST(Gap, DrawsWhatMustAgreeBeforeAndWithTheCauses) {
  GapBench bench(samplePath(QStringLiteral("paper-table-1.alidade")));
  const std::string says = bench.closures();
  EXPECT_THAT(says, HasSubstr("R(180°) − R(0°) = 1.96 ± 0.29 mm, 13.2 σ; with the causes "));
  EXPECT_THAT(says, HasSubstr("Δx(180°) − Δx(0°) = −0.65 ± 0.18 mm, 7.3 σ; with the causes "));
  EXPECT_THAT(bench.shown(), HasSubstr("With the causes in the model, these quantities agree.\n"));
  EXPECT_THAT(GapBench(cleanTrial).shown(),
              HasSubstr("For one rigid arc turned about a level axis, these quantities agree.\n"));
}

QString closurePath(const char* name) {
  return QStringLiteral(ALIDADE_REFERENCE_DIR "/closures/sessions/%1.alidade").arg(QString::fromLatin1(name));
}

/// The probability of the first cause, as shown on the page.
std::string probabilityText(const Session& session, bool withReference) {
  const Diagnosis diagnosis = *diagnose(*examine(session).measurement, {.withReference = withReference});
  return numberText(100 * diagnosis.causes.at(0).probability, 0).toStdString() + " %\n";
}

TEST(Gap, WeighsTheCausesWithTheReferenceWhileItIsAskedTo) {
  GapBench bench(closurePath("640941"));
  const auto box = [&] { return bench.page()->findChild<QCheckBox*>(QStringLiteral("with reference")); };
  const Session& session = bench.open->document().session();
  const std::string without = probabilityText(session, false), with = probabilityText(session, true);
  ASSERT_NE(without, with);
  ASSERT_TRUE(box()->isVisibleTo(bench.page()));
  EXPECT_FALSE(box()->isChecked());
  EXPECT_THAT(bench.shown(), HasSubstr(without));
  const auto toggle = [&] {
    box()->setFocus();
    QTest::keyClick(box(), Qt::Key_Space);
    bench.waitUntilIdle();
  };
  toggle();
  EXPECT_TRUE(box()->isChecked());
  EXPECT_TRUE(box()->isEnabled());
  EXPECT_TRUE(box()->hasFocus()) << "the keyboard comes back to it";
  EXPECT_THAT(bench.shown(), HasSubstr(with));
  EXPECT_EQ(bench.open->document().undoStack().count(), 0) << "it is no part of the session";

  changeField(bench.open->document(), {.field = "geometry.sigma_distance_mm"}, "0.5");
  bench.waitUntilIdle();
  EXPECT_TRUE(box()->isChecked()) << "an edit leaves it on";
  bench.open->undo();
  bench.waitUntilIdle();
  toggle();
  EXPECT_THAT(bench.shown(), HasSubstr(without));

  toggle();
  ASSERT_TRUE(bench.open->files().open(closurePath("067998")));
  bench.waitUntilIdle();
  EXPECT_FALSE(box()->isChecked()) << "another session starts without it";
}

TEST(Gap, OffersTheReferenceOnlyWithItsSigma) {
  GapBench bench(closurePath("640941"));
  const auto* box = bench.page()->findChild<QCheckBox*>(QStringLiteral("with reference"));
  EXPECT_THAT(bench.shown(), HasSubstr("Sizes that would explain Δd − reference\n"));
  changeField(bench.open->document(), {.field = "acceptance.sigma_reference_mm"}, "");
  bench.waitUntilIdle();
  EXPECT_FALSE(box->isVisibleTo(bench.page()));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("Sizes that would explain")));
}

TEST(Gap, TellsWhatItWouldTakeToExplainTheReference) {
  GapBench bench(closurePath("292351"));
  const Diagnosis diagnosis = *diagnose(*examine(bench.open->document().session()).measurement);
  ASSERT_GE(diagnosis.whatItWouldTake.size(), 2u);
  for (const Required& required : diagnosis.whatItWouldTake)
    EXPECT_THAT(bench.shown(), HasSubstr(alidade::causeTitle(required.effect) + "\n"));
  EXPECT_THAT(bench.shown(), HasSubstr("plausible sizes\n"));
}

TEST(Gap, IsNoWiderThanItsPage) {
  const auto session = loadSession(closurePath("292351").toStdString());
  const auto gap =
      std::make_shared<const Gap>(assessGap(std::make_shared<const Evaluation>(evaluateFit(*session))));
  GapPanel page;
  page.setGap(gap);
  for (const int width : {340, 640, 900}) {  // the middle one just fits two columns
    page.resize(width, 600);
    page.show();
    QCoreApplication::processEvents();
    EXPECT_LE(page.widget()->minimumSizeHint().width(), page.viewport()->width()) << width;
  }
}

TEST(Gap, AddsACauseToTheModelWithOneKeyAndShowsBeforeAndAfter) {
  GapBench bench(sagTrial);
  ASSERT_TRUE(bench.tick("gravity_sag"));
  EXPECT_TRUE(bench.tick("gravity_sag")->isChecked());
  EXPECT_FALSE(bench.button("remove ticked"));
  bench.press("add ticked");
  EXPECT_THAT(bench.effects(), ElementsAre("gravity_sag"));
  EXPECT_THAT(bench.shown(), HasSubstr("No gap: within the noise\n"));
  EXPECT_THAT(bench.shown(), HasSubstr("\nwithout model effects\n"));
  EXPECT_THAT(bench.shown(), HasSubstr("\nin the model: gravity sag\n"));
  const Intersection after = evaluate(bench.open->document().session()).fit.intersection.value();
  EXPECT_THAT(bench.shown(), HasSubstr(sizeWithExpanded(after.value, after.expanded, "")));
  EXPECT_FALSE(bench.button("add ticked"));
  EXPECT_FALSE(bench.tick("gravity_sag")->isChecked()) << "else it would be taken out again at once";
  EXPECT_FALSE(bench.button("remove ticked")->isEnabled());
  EXPECT_TRUE(bench.page()->hasFocus()) << "the keyboard stays on the page";
}

TEST(Gap, WhatWasAddedIsUndoneRedoneAndSaved) {
  GapBench bench(sagTrial);
  const Session original = bench.open->document().session();
  bench.press("add ticked");
  EXPECT_EQ(bench.open->document().undoStack().undoText(), QStringLiteral("Estimate gravity sag"));
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("added.alidade"));
  ASSERT_FALSE(bench.open->document().save(path));
  EXPECT_THAT(loadSession(path.toStdString())->model.effects, ElementsAre("gravity_sag"));
  bench.open->undo();
  bench.waitUntilIdle();
  Session undone = bench.open->document().session();
  EXPECT_EQ(undone.journal.size(), 1U) << "the file has it";
  undone.journal.clear();
  EXPECT_EQ(undone, original);
  EXPECT_THAT(bench.shown(), HasSubstr("One cause: gravity sag\n"));
  bench.open->redo();
  bench.waitUntilIdle();
  bench.tick("gravity_sag")->click();
  bench.press("remove ticked");
  EXPECT_THAT(bench.effects(), IsEmpty());
}

TEST(Gap, AddsAllThatLookAlikeInOneStep) {
  GapBench bench(tiltTrial);
  const Diagnosis diagnosis = *diagnose(*examine(bench.open->document().session()).measurement);
  const Cause& cause = diagnosis.causes.front();
  ASSERT_EQ(cause.indistinguishableFrom.size(), 3u);
  bench.press("add look-alikes");
  Ids group{cause.effect};
  group.insert(group.end(), cause.indistinguishableFrom.begin(), cause.indistinguishableFrom.end());
  EXPECT_EQ(bench.effects(), group);
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  EXPECT_GT(evaluate(bench.open->document().session()).fit.intersection->expanded,
            2 * diagnosis.steps[0].intersection->expanded)
      << "what they differ by is in U";
}

TEST(Gap, AddsOnlyWhatIsTicked) {
  GapBench bench(lobingAndDriftTrial);
  const std::string first =
      diagnose(*examine(bench.open->document().session()).measurement)->causes[0].effect;
  bench.tick(first.c_str())->click();
  bench.press("add ticked");
  ASSERT_EQ(bench.effects().size(), 1u);
  EXPECT_NE(bench.effects()[0], first);
  bench.open->undo();
  bench.waitUntilIdle();
  for (QCheckBox* tick : bench.page()->findChildren<QCheckBox*>())
    if (tick->isChecked() && tick->isVisibleTo(bench.page())) tick->click();
  EXPECT_FALSE(bench.button("add ticked")->isEnabled());
}

TEST(Gap, AddsSeveralCausesInOneStep) {
  GapBench bench(lobingAndDriftTrial);
  bench.press("add ticked");
  EXPECT_EQ(bench.effects().size(), 2u);
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  EXPECT_THAT(bench.shown(), HasSubstr("No gap: within the noise\n"));
}

TEST(Gap, AddsACandidateFromTheTable) {
  GapBench bench(collimationTrial);
  EXPECT_TRUE(bench.button("add candidate")->text().contains(bench.candidate(0, 0).toLower()));
  bench.candidates()->setFocus();
  QTest::keyClick(bench.candidates(), Qt::Key_Down);
  const QString second = bench.candidate(1, 0);
  EXPECT_EQ(bench.candidate(1, 3), QStringLiteral("look-alike"));
  bench.press("add candidate");
  ASSERT_EQ(bench.effects().size(), 1u);
  EXPECT_EQ(causeTitle(bench.effects()[0]), second);
}

TEST(Gap, SetsTheVerticalAngleRelationRight) {
  GapBench bench(relationTrial);
  bench.press("relation");
  EXPECT_EQ(bench.open->document().session().model.verticalAngle, "planar");
  EXPECT_THAT(bench.shown(), HasSubstr("No gap: within the noise\n"));
  bench.open->undo();
  bench.waitUntilIdle();
  bench.press("add ticked");
  EXPECT_THAT(bench.shown(), HasSubstr("No gap: within the noise\n"));
}

TEST(Gap, LeadsToAMisreadValueAndExcludesItsRow) {
  GapBench bench(misreadTrial);
  EXPECT_THAT(bench.shown(), HasSubstr("0°, point 11, horizontal: off by +29.1″\n"));
  EXPECT_FALSE(bench.button("add ticked"));
  bench.press("go to reading");
  EXPECT_EQ(bench.open->currentTable()->currentIndex().row(), 10);
  bench.press("exclude row");
  EXPECT_TRUE(bench.open->document().session().positions[0].readings[10].excluded);
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  EXPECT_THAT(bench.shown(), HasSubstr("No gap: within the noise\n"));
}

TEST(Gap, WarnsBeforeARowIsLeftOutForWhatMayBeAJump) {
  Gap gap{.evaluation = std::make_shared<const Evaluation>(evaluateFit(paperSession())),
          .diagnosis = Diagnosis{},
          .reason = {},
          .stages = {}};
  gap.diagnosis->causes.push_back({.effect = "gross_error",
                                   .parameters = {},
                                   .indistinguishableFrom = {"orientation_jump"},
                                   .readings = {ReadingDeviation{}}});
  RemedyList list;
  list.setGap(gap);
  QString texts;
  for (const QLabel* label : list.findChildren<QLabel*>()) texts += label->text() + u'\n';
  EXPECT_THAT(texts.toStdString(),
              HasSubstr("The cause may also be a jump of the orientation, which would move Δd"));
}

TEST(Gap, SaysWhatToDoWhereNothingCanBeAdded) {
  {
    GapBench bench(jumpTrial);
    EXPECT_THAT(bench.shown(), HasSubstr("The jump happened before 0°, row 35"));
    bench.press("go to jump");
    EXPECT_EQ(bench.open->currentTable()->currentIndex().row(), 34);
  }
  {
    GapBench bench(noiseTrial);
    EXPECT_THAT(bench.shown(), HasSubstr("Nothing to add to the model"));
  }
  GapBench bench(harmonicTrial);
  EXPECT_THAT(bench.shown(), HasSubstr("The form: radius"));
}

TEST(Gap, SaysWhenWhichRowsOfAJumpMayBeLeftOut) {
  const auto evaluation =
      std::make_shared<const Evaluation>(evaluateFit(*loadSession(trialPath(jumpTrial).toStdString())));
  const auto adviceAt = [&](double row) {
    Gap gap{.evaluation = evaluation, .diagnosis = Diagnosis{}, .reason = {}, .stages = {}};
    gap.diagnosis->causes.push_back({.effect = "orientation_jump",
                                     .parameters = {{.name = "row", .value = row, .sigma = 0, .unit = "1"}},
                                     .indistinguishableFrom = {},
                                     .readings = {}});
    RemedyList list;
    list.setGap(gap);
    QString texts;
    for (const QLabel* label : list.findChildren<QLabel*>()) texts += label->text();
    for (const QPushButton* button : list.findChildren<QPushButton*>()) texts += u'\n' + button->text();
    return texts.toStdString();
  };
  const std::string goTo = "\nGo to the reading", after = "\nExclude rows after the jump";
  EXPECT_THAT(adviceAt(35), EndsWith("if the pointing zero of the next position was sighted after the jump." +
                                     goTo + after));
  EXPECT_THAT(adviceAt(4), EndsWith("repeat this position." + goTo)) << "too few are left";
  EXPECT_THAT(adviceAt(67),
              EndsWith("position. Or leave out the rows after the jump, if the pointing zero of the "
                       "next position was sighted after the jump." +
                       goTo + after));
  EXPECT_THAT(adviceAt(68 + 35), EndsWith("position. Or leave out the rows after the jump." + goTo + after));
}

/// Excluding the rows after the jump preserves Δd. The remaining rows and their zero were read before the
/// jump; the zero of the other position was sighted after the jump.
TEST(Gap, LeavesOutTheRowsOnOneSideOfAJump) {
  constexpr double truth = 2.329085876961523;
  GapBench bench(jumpTrial);
  bench.press("exclude after");
  const auto& readings = bench.open->document().session().positions[0].readings;
  for (std::size_t row = 0; row < readings.size(); ++row) EXPECT_EQ(readings[row].excluded, row >= 34) << row;
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  const Intersection found = *evaluate(bench.open->document().session()).fit.intersection;
  EXPECT_LT(std::abs(found.value - truth), found.expanded);
}

TEST(Gap, LeavesOutOnlyTheRowsAfterAJumpInTheLastPosition) {
  Session session = *loadSession(trialPath(jumpTrial).toStdString());
  std::swap(session.positions[0], session.positions[1]);
  Evaluation evaluation;
  evaluation.session = session;
  evaluation.examined = examine(session);
  const Gap gap{.evaluation = std::make_shared<const Evaluation>(evaluation),
                .diagnosis = {},
                .reason = {},
                .stages = {}};
  const auto before = [&](double row) {
    return jumpOf(gap, {.effect = "orientation_jump",
                        .parameters = {{.name = "row", .value = row, .sigma = 0, .unit = "1"}},
                        .indistinguishableFrom = {},
                        .readings = {}});
  };
  const Jump within = before(68 + 35).value();
  EXPECT_TRUE(within.isLast);
  EXPECT_EQ(within.place.position, 0u) << "180° is read last, wherever the file has it";
  EXPECT_EQ(within.after->first, 34u);
  EXPECT_EQ(within.after->count, 34u);
  EXPECT_FALSE(before(68 + 4)->after) << "three sightings only just determine the arc";
  EXPECT_FALSE(before(67)->before) << "nor do two";
  EXPECT_FALSE(before(67)->isLast);
  EXPECT_FALSE(within.before) << "nothing was read later that stands as they do";
}

/// The stated σ is 2″. The trial's noise factor is unknown, but the residuals are noise and Δd is correct.
TEST(Gap, StatesTheNoiseThatTheReadingsShow) {
  GapBench bench(noiseTrial);
  const Diagnosis diagnosis = *diagnose(*examine(bench.open->document().session()).measurement);
  const Instrument before = bench.open->document().session().instrument;
  bench.press("state noise");
  const Instrument& instrument = bench.open->document().session().instrument;
  const double stated = 2 * diagnosis.causes.front().parameters.front().value;
  EXPECT_NEAR(std::stod(instrument.sigmaHorizontalArcsec), stated, 0.05 * stated) << "two digits";
  EXPECT_EQ(instrument.sigmaVerticalArcsec, instrument.sigmaHorizontalArcsec);
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  EXPECT_THAT(bench.shown(), HasSubstr("No gap: within the noise\n"));
  EXPECT_NE(instrument, before);
  bench.open->undo();
  EXPECT_EQ(instrument, before);
  bench.waitUntilIdle();
  EXPECT_TRUE(bench.button("state noise"));
}

TEST(Gap, SaysWhatIsMissingWhereThereIsNothingToDiagnose) {
  OpenWindow open;
  QTest::keyClick(open.window.get(), Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  const auto* page = open->findChild<GapPanel*>();
  const auto says = [page](const char* text) {
    for (const QLabel* label : page->findChildren<QLabel*>())
      if (label->isVisibleTo(page) && label->text().contains(QString::fromUtf8(text))) return true;
    return false;
  };
  EXPECT_TRUE(says("There is nothing to compare yet"));
  EXPECT_FALSE(says("Before and after"));
}

TEST(Gap, HasNoTableOfWhatGoesUnseenWhereNothingDoes) {
  Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(paperSession())));
  ASSERT_TRUE(gap.diagnosis);
  GapPanel page;
  const auto shown = [&](const std::vector<UndetectableEffect>& undetectable) {
    gap.diagnosis->undetectable = undetectable;
    page.setGap(std::make_shared<const Gap>(gap));
    QString texts;
    for (const QLabel* label : page.findChildren<QLabel*>())
      if (label->isVisibleTo(&page)) texts += label->text() + QLatin1Char('\n');
    return texts.toStdString();
  };
  EXPECT_THAT(shown({{.effect = "trunnion_tilt", .influence = 100, .visibleSigma = 0.5}}),
              HasSubstr("moves Δd (mm)"));
  EXPECT_THAT(shown({}), Not(HasSubstr("moves Δd (mm)")));
  EXPECT_THAT(shown({}), HasSubstr("An effect of plausible size that moved Δd noticeably"));
}

TEST(Gap, OfThreeReadingsIsNone) {
  Session session = paperSession();
  for (Position& position : session.positions) position.readings.resize(3);
  // Two arcs must close, which is as much as readings can be compared with.
  EXPECT_TRUE(assessGap(std::make_shared<const Evaluation>(evaluateFit(session))).diagnosis);
  session.positions.pop_back();
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(session)));
  EXPECT_FALSE(gap.diagnosis);
  EXPECT_EQ(std::get<Absence>(gap.reason), Absence::NothingLeftOver);
  EXPECT_THAT(reasonForNone(gap), HasSubstr("only just determine the arc"));
}

TEST(Gap, IsToldWhileThePageIsHidden) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(trialPath(sagTrial)));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  const auto gapHint = [&] { return open->findChild<QLabel*>(QStringLiteral("gap hint")); };
  QLabel* hint = gapHint();
  ASSERT_TRUE(hint && hint->isVisible());
  EXPECT_TRUE(hint->text().contains(QStringLiteral("gravity sag (")));
  auto* page = open->findChild<GapPanel*>();
  PageTabs* tabs = open->pageTabs()[1];
  EXPECT_FALSE(tabs->tabIcon(tabs->indexOf(page)).isNull());
  emit hint->linkActivated(QStringLiteral("gap"));
  EXPECT_EQ(tabs->currentWidget(), page);

  ASSERT_TRUE(open->files().open(trialPath(cleanTrial)));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  EXPECT_FALSE(gapHint()) << "no line of the headline is of a gap";
  EXPECT_TRUE(tabs->tabIcon(tabs->indexOf(page)).isNull());
}

// Links of rich text take their colour when the text is set.
TEST(Gap, IsLinkedToInTheColoursOfTheTheme) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(trialPath(sagTrial)));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  auto* hint = open->findChild<QLabel*>(QStringLiteral("gap hint"));
  const QPalette before = QApplication::palette();
  const auto showsLinkIn = [&](Qt::GlobalColor color) {
    QPalette palette = before;
    palette.setColor(QPalette::Link, color);
    QApplication::setPalette(palette);
    QCoreApplication::processEvents();
    const QImage image = hint->grab().toImage();
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y) == QColor(color)) return true;
    return false;
  };
  EXPECT_TRUE(showsLinkIn(Qt::red));
  EXPECT_TRUE(showsLinkIn(Qt::darkCyan));
  EXPECT_FALSE(hint->isHidden());
  QApplication::setPalette(before);
}

TEST(Gap, StandsAmongTheFindingsWhichLeadToItsPage) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(trialPath(collimationTrial)));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  auto* findings = open->findChild<FindingsPanel*>();
  const auto texts = [&] {
    QStringList all;
    for (int row = 0; row < findings->count(); ++row) all.append(findings->item(row)->text());
    return all.join(u'\n').toStdString();
  };
  EXPECT_THAT(texts(),
              HasSubstr("Model and readings disagree, see “Gap”. One of 2 causes indistinguishable here."));
  EXPECT_THAT(texts(), Not(HasSubstr("No problems.")));
  findings->setFocus();
  findings->setCurrentRow(0);
  QTest::keyClick(findings, Qt::Key_Return);
  EXPECT_TRUE(open->findChild<GapPanel*>()->isVisible());

  ASSERT_TRUE(open->files().open(trialPath(cleanTrial)));
  EXPECT_THAT(texts(), IsEmpty()) << "of another session nothing is known yet";
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  EXPECT_EQ(texts(), "No problems.");
}

TEST(Gap, IsToldAsOldFromTheEditToTheNextDiagnosis) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(trialPath(sagTrial)));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  QCoreApplication::processEvents();
  const auto isHinted = [&] { return open->findChild<QLabel*>(QStringLiteral("gap hint")) != nullptr; };
  auto* findings = open->findChild<FindingsPanel*>();
  const auto finding = [&] { return findings->item(0)->text().toStdString(); };
  EXPECT_TRUE(isHinted());
  changeField(open->document(), {.field = "geometry.sigma_distance_mm"}, "0.5");
  EXPECT_FALSE(isHinted()) << "it belongs to the verdict of another state";
  EXPECT_THAT(finding(), HasSubstr("Before the latest changes: One cause: gravity sag."));
  open.waitUntilIdle();
  EXPECT_THAT(finding(), HasSubstr("Before the latest changes: One cause: gravity sag."))
      << "the new fit knows no better";
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  EXPECT_TRUE(isHinted());
  EXPECT_THAT(finding(), HasSubstr("Model and readings disagree,"));
}

TEST(Gap, NothingIsCalledSoundBesideAReadingThatLooksMisread) {
  Evaluation evaluation = evaluate(*loadSession(trialPath(cleanTrial).toStdString()));
  FindingsPanel findings;
  findings.setEvaluation(evaluation);
  findings.setGap({});
  ASSERT_EQ(findings.count(), 1);
  EXPECT_EQ(findings.item(0)->text(), QStringLiteral("No problems."));
  evaluation.suspects = evaluate(*loadSession(trialPath(misreadTrial).toStdString())).suspects;
  ASSERT_FALSE(evaluation.suspects.empty());
  findings.setGapStale();
  EXPECT_EQ(findings.count(), 1) << "until something else is known";
  findings.setEvaluation(evaluation);
  EXPECT_EQ(findings.count(), 0);
}

TEST(Gap, AProblemThatIsMendedIsNoLongerListedWhileTheDiagnosisIsAtWork) {
  FindingsPanel findings;
  Evaluation evaluation = evaluate(*loadSession(trialPath(cleanTrial).toStdString()));
  const Evaluation sound = evaluation;
  evaluation.examined.problems.push_back(
      {.what = "is odd", .where = {.position = 0, .reading = 2, .field = "vertical"}});
  findings.setEvaluation(evaluation);
  ASSERT_EQ(findings.count(), 1);
  findings.setGapStale();
  findings.setEvaluation(sound);
  EXPECT_EQ(findings.count(), 0);
}

TEST(Gap, PartsAddUpToOne) {
  for (const char* trial : {collimationTrial, misreadTrial, harmonicTrial}) {
    const auto session = loadSession(trialPath(trial).toStdString());
    const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(*session)));
    std::map<std::string, double> sums;
    for (const GapShare& share : gap.diagnosis->where) sums[share.by] += share.share;
    for (const auto& [by, sum] : sums) EXPECT_NEAR(sum, 1, 1e-9) << by;  // rounding of a few dozen terms
  }
}

TEST(GapJob, DeliversTheNewestAndForgetsWhatWasCancelled) {
  GapJob job;
  job.setWatched(true);
  std::vector<std::string> titles;
  QObject::connect(&job, &GapJob::assessed, [&](const SharedGap& gap) {
    titles.push_back(gap->evaluation->session.title);
    EXPECT_TRUE(gap->diagnosis);
  });
  Session session = paperSession();
  for (int i = 0; i < 20; ++i) {
    session.title = std::to_string(i);
    job.request(std::make_shared<const Evaluation>(evaluateFit(session)));
    QCoreApplication::processEvents();
  }
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(titles.back(), "19");
  const std::size_t delivered = titles.size();
  job.request(std::make_shared<const Evaluation>(evaluateFit(session)));
  job.cancel();
  QTest::qWait(50);
  EXPECT_EQ(titles.size(), delivered);
}

TEST(GapJob, TakesUpAgainWhatWasStopped) {
  std::stop_source stop;
  stop.request_stop();
  const auto evaluation = std::make_shared<const Evaluation>(evaluateFit(paperSession()));
  EXPECT_FALSE(assessGap(evaluation, stop.get_token()).diagnosis);
  GapJob job;
  job.setWatched(true);
  std::vector<bool> hasDiagnosis;
  QObject::connect(&job, &GapJob::assessed, [&](const SharedGap& gap) {
    EXPECT_EQ(gap->evaluation, evaluation);
    hasDiagnosis.push_back(gap->diagnosis.has_value());
  });
  job.request(evaluation);
  ASSERT_TRUE(waitFor([&] { return job.isAtWork(); }));
  job.cancel();
  job.request(evaluation);
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(hasDiagnosis, std::vector{true});
}

TEST(GapJob, AnswersAnewWithTheReference) {
  const auto session = loadSession(closurePath("640941").toStdString());
  const auto evaluation = std::make_shared<const Evaluation>(evaluateFit(*session));
  GapJob job;
  job.setWatched(true);
  std::vector<bool> isWithReference;
  QObject::connect(&job, &GapJob::assessed,
                   [&](const SharedGap& gap) { isWithReference.push_back(gap->isWithReference); });
  job.request(evaluation);
  ASSERT_TRUE(waitFor([&] { return job.isAtWork(); }));
  job.setWithReference(true);
  job.request(evaluation);
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(isWithReference, std::vector{true}) << "what was at work without it is not delivered";
}

TEST(GapJob, WaitsForRestUnlessWatched) {
  GapJob job;
  int delivered = 0;
  QObject::connect(&job, &GapJob::assessed, [&] { ++delivered; });
  job.request(std::make_shared<const Evaluation>(evaluateFit(blankSession())));
  QTest::qWait(GapJob::restMilliseconds / 5);
  EXPECT_EQ(delivered, 0);
  job.setWatched(true);
  ASSERT_TRUE(waitFor([&] { return delivered == 1; }));
  EXPECT_TRUE(job.isIdle());
}

// The window must not show a verdict without the row that the report names beside it.
TEST(GapJob, DeliversTheRowsOnWhichTheVerdictDepends) {
  Session session = *loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString());
  session.acceptance.toleranceMm = "0.5";
  GapJob job;
  job.setWatched(true);
  QStringList lines;
  const auto note = [&](const SharedGap& gap) {
    lines.append(qText(headlineOf(*gap).line(Headline::Line::Kind::Row)));
  };
  QObject::connect(&job, &GapJob::assessed, note);
  QObject::connect(&job, &GapJob::completed, note);
  job.request(std::make_shared<const Evaluation>(evaluateFit(session)));
  ASSERT_TRUE(waitFor([&] { return lines.size() == 2; }));
  EXPECT_EQ(lines, QStringList({QString(), QStringLiteral("The verdict depends on a single row: undecided "
                                                          "without 0° point 3")}));
  job.request(std::make_shared<const Evaluation>(evaluateFit(session)));
  ASSERT_TRUE(waitFor([&] { return lines.size() == 3; }));
  job.cancel();
  QTest::qWait(1000);
  EXPECT_EQ(lines.size(), 3) << "the session has changed since";
}

TEST(TrialJob, StartsAnewAfterAStop) {
  std::stop_source stop;
  stop.request_stop();
  const DiagnosedTrial stopped = diagnoseTrial({.protocol = "paper"}, 1, stop.get_token());
  EXPECT_FALSE(stopped.gap.diagnosis);
  EXPECT_FALSE(stopped.problem.empty());
  TrialJob job;
  std::vector<SharedTrial> diagnosed;
  QObject::connect(&job, &TrialJob::diagnosed, [&](const SharedTrial& trial) { diagnosed.push_back(trial); });
  job.start({.protocol = "full"}, 1, 3);
  job.stop();
  job.start({.protocol = "paper"}, 1, 1);
  ASSERT_TRUE(waitFor([&] { return !job.isAtWork(); }));
  ASSERT_EQ(diagnosed.size(), 1U);
  EXPECT_TRUE(diagnosed.front()->problem.empty());
  EXPECT_TRUE(diagnosed.front()->gap.diagnosis);
}

TEST(CauseText, NamesEverythingADiagnosisMayName) {
  for (const std::string& id : diagnosableEffects()) {
    EXPECT_FALSE(causeName(id).contains(u'_')) << id;
    EXPECT_TRUE(causeTitle(id).at(0).isUpper()) << id;
    Diagnosis diagnosis;
    diagnosis.verdict = DiagnosisVerdict::SingleCause;
    diagnosis.causes = {{.effect = id,
                         .probability = 1,
                         .parameters = {{.name = "size", .value = 2, .sigma = 0.1, .unit = "1"}},
                         .indistinguishableFrom = {},
                         .readings = {}}};
    EXPECT_TRUE(qText(sentenceOf(diagnosis))
                    .startsWith(QStringLiteral("The gap is best explained by ") + causeName(id) + u'.'))
        << id;
  }
}

}  // namespace
}  // namespace alidade::ui
