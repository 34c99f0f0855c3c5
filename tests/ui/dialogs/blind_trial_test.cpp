#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <algorithm>

#include "core/simulation/trial_series.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/blind_trial_dialog.h"
#include "ui/main_window.h"
#include "ui/panels/gap/gap_panel.h"
#include "ui/panels/parts/data_table.h"
#include "ui/settings/theme.h"
#include "ui/text/cause_text.h"
#include "ui/text/trial_text.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int seed = 4711;

struct TrialBench {
  explicit TrialBench(const char* plan = "", const char* kind = "") {
    select(0, plan);
    select(1, kind);
    dialog.findChild<QSpinBox*>()->setValue(seed);
    dialog.show();
  }

  void select(int box, const char* data) {
    auto* combo = dialog.findChildren<QComboBox*>().at(box);
    combo->setCurrentIndex(combo->findData(QString::fromLatin1(data)));
  }
  QPushButton* button(const char* name) { return dialog.findChild<QPushButton*>(QString::fromLatin1(name)); }
  void press(const char* name) {
    ASSERT_TRUE(button(name)->isEnabled()) << name;
    QTest::keyClick(button(name), Qt::Key_Space);
    ASSERT_TRUE(waitFor([this] { return !dialog.job().isAtWork(); }));
  }
  DataTable* table() { return dialog.findChild<DataTable*>(); }
  QString cell(int row, int column) { return table()->model()->index(row, column).data().toString(); }
  std::string shown() {
    QString texts;
    for (const QLabel* label : dialog.findChildren<QLabel*>())
      if (label->isVisibleTo(&dialog)) texts += label->text() + QLatin1Char('\n');
    return texts.toStdString();
  }

  BlindTrialDialog dialog;
};

TEST(BlindTrial, KeepsTheTruthSealedUntilItIsOpened) {
  TrialBench bench("full", "orientation_jump");
  EXPECT_FALSE(bench.button("open seal")->isEnabled());
  bench.press("draw");
  EXPECT_THAT(bench.shown(), HasSubstr("Sealed."));
  EXPECT_THAT(bench.shown(), HasSubstr("The gap is best explained by a jump of the orientation"));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("Knocked after")));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("True Δd")));
  bench.press("open seal");
  EXPECT_THAT(bench.shown(), HasSubstr("Right. The truth was a jump of the orientation"));
  EXPECT_THAT(bench.shown(), HasSubstr("Knocked after"));
  EXPECT_THAT(bench.shown(), HasSubstr("Right: 1 of 1 (100 %)"));
  EXPECT_FALSE(bench.button("open seal")->isEnabled());
}

TEST(BlindTrial, IsTheOneOfItsNumber) {
  TrialBench bench("two-face", "collimation");
  bench.press("draw");
  const BlindTrial same = *drawBlindTrial({.protocol = "two-face", .kinds = {"collimation"}}, seed);
  EXPECT_EQ(bench.dialog.current()->trial.session, same.session);
  EXPECT_EQ(bench.dialog.findChild<QSpinBox*>()->value(), seed + 1) << "the next draw is another";
  bench.press("open seal");
  for (const QString& line : truthLines(same)) EXPECT_THAT(bench.shown(), HasSubstr(line.toStdString()));
}

TEST(BlindTrial, ScoresAStretchAsTheCoreDoes) {
  constexpr int count = 6;
  TrialBench bench("paper");
  bench.dialog.findChildren<QSpinBox*>().last()->setValue(count);
  bench.press("series");
  const auto scored = *scoreDrawnTrials({.count = count, .threads = 1}, {.protocol = "paper"},
                                        static_cast<std::uint64_t>(seed));
  const auto right =
      std::count_if(scored.begin(), scored.end(), [](const ScoredTrial& trial) { return trial.score.right; });
  EXPECT_THAT(bench.shown(), HasSubstr("Right: " + std::to_string(right) + " of " + std::to_string(count)));
  const auto* table = bench.dialog.findChild<DataTable*>();
  ASSERT_EQ(table->model()->rowCount(), count);
  EXPECT_EQ(table->model()->index(count - 1, 0).data().toInt(), seed) << "the newest first";
}

TEST(BlindTrial, StaysSealedInTheListUntilItIsReturnedTo) {
  TrialBench bench("full", "orientation_jump");
  bench.press("draw");
  const SharedTrial first = bench.dialog.current();
  bench.press("draw");
  bench.press("open seal");
  const DataTable& table = *bench.table();
  ASSERT_EQ(table.model()->rowCount(), 2);
  EXPECT_EQ(bench.cell(1, 0), QString::number(seed));
  EXPECT_EQ(bench.cell(1, 2), QStringLiteral("sealed"));
  EXPECT_EQ(bench.cell(0, 2), QStringLiteral("a jump of the orientation"));
  EXPECT_THAT(bench.shown(), HasSubstr("of 1 ("));
  EXPECT_THAT(bench.shown(), HasSubstr("still sealed: 1."));

  bench.table()->setFocus();
  QTest::keyClick(bench.table(), Qt::Key_Down);
  EXPECT_EQ(bench.dialog.current(), first);
  EXPECT_THAT(bench.shown(), HasSubstr("Sealed."));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("True Δd")));
  bench.press("open seal");
  EXPECT_EQ(bench.cell(1, 2), QStringLiteral("a jump of the orientation"));
  EXPECT_THAT(bench.shown(), HasSubstr("of 2 ("));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("still sealed")));
  EXPECT_EQ(table.currentIndex().row(), 1) << "the one whose seal was opened stays in front";
}

TEST(BlindTrial, ASealedOneOutlivesAStretch) {
  TrialBench bench("paper", "none");
  bench.press("draw");
  const SharedTrial sealed = bench.dialog.current();
  bench.dialog.findChildren<QSpinBox*>().last()->setValue(3);
  bench.press("series");
  EXPECT_NE(bench.dialog.current(), sealed) << "a stretch shows its newest";
  EXPECT_EQ(bench.cell(3, 2), QStringLiteral("sealed"));
  QTest::mouseClick(bench.table()->viewport(), Qt::LeftButton, {},
                    bench.table()->visualRect(bench.table()->model()->index(3, 0)).center());
  EXPECT_EQ(bench.dialog.current(), sealed);
  EXPECT_TRUE(bench.button("open seal")->isEnabled());
}

TEST(BlindTrial, AStretchLeavesTheChosenOneInFrontAndItsNumberAlone) {
  TrialBench bench("paper", "none");
  bench.press("draw");
  bench.dialog.findChildren<QSpinBox*>().last()->setValue(10000);
  QTest::keyClick(bench.button("series"), Qt::Key_Space);
  auto* number = bench.dialog.findChild<QSpinBox*>();
  EXPECT_FALSE(number->isEnabled());
  EXPECT_FALSE(bench.dialog.findChild<QComboBox*>()->isEnabled());
  const auto rows = [&] { return bench.table()->model()->rowCount(); };
  ASSERT_TRUE(waitFor([&] { return rows() > 3; }));
  bench.table()->setCurrentIndex(bench.table()->model()->index(rows() - 1, 0));
  const SharedTrial chosen = bench.dialog.current();
  EXPECT_EQ(chosen->trial.seal.id, std::to_string(seed));
  const int before = rows();
  ASSERT_TRUE(waitFor([&] { return rows() > before; }));
  EXPECT_EQ(bench.dialog.current(), chosen);
  bench.press("series");
  EXPECT_TRUE(number->isEnabled());
  EXPECT_EQ(number->value(), seed + rows()) << "one on for every trial drawn";
}

TEST(BlindTrial, ADrawLeavesInFrontWhatWasChosenMeanwhile) {
  TrialBench bench("full", "none");
  bench.press("draw");
  const SharedTrial first = bench.dialog.current();
  QTest::keyClick(bench.button("draw"), Qt::Key_Space);
  ASSERT_TRUE(bench.dialog.job().isAtWork());
  bench.table()->setFocus();
  bench.table()->setCurrentIndex(bench.table()->model()->index(0, 0));
  ASSERT_TRUE(waitFor([&] { return !bench.dialog.job().isAtWork(); }));
  ASSERT_EQ(bench.table()->model()->rowCount(), 2);
  EXPECT_EQ(bench.dialog.current(), first);
  EXPECT_EQ(bench.table()->currentIndex().row(), 1);
  EXPECT_FALSE(bench.button("open seal")->hasFocus()) << "it would open another one's";
  bench.press("draw");
  EXPECT_EQ(bench.table()->currentIndex().row(), 0) << "the next draw is shown again";
}

TEST(BlindTrial, AStretchIsFollowedAgainFromItsNewest) {
  TrialBench bench("paper", "none");
  bench.dialog.findChildren<QSpinBox*>().last()->setValue(10000);
  QTest::keyClick(bench.button("series"), Qt::Key_Space);
  const auto rows = [&] { return bench.table()->model()->rowCount(); };
  ASSERT_TRUE(waitFor([&] { return rows() > 2; }));
  bench.table()->setCurrentIndex(bench.table()->model()->index(1, 0));
  bench.table()->setCurrentIndex(bench.table()->model()->index(0, 0));
  const int before = rows();
  ASSERT_TRUE(waitFor([&] { return rows() > before; }));
  EXPECT_EQ(bench.table()->currentIndex().row(), 0);
  bench.press("series");
}

TEST(BlindTrial, AStretchIsStopped) {
  TrialBench bench("paper", "none");
  bench.dialog.findChildren<QSpinBox*>().last()->setValue(10000);
  QTest::keyClick(bench.button("series"), Qt::Key_Space);
  ASSERT_TRUE(waitFor([&] { return bench.dialog.current() != nullptr; }));
  EXPECT_FALSE(bench.button("draw")->isEnabled());
  bench.press("series");
  EXPECT_LT(bench.dialog.findChild<DataTable*>()->model()->rowCount(), 1000);
  bench.press("draw");
  EXPECT_THAT(bench.shown(), HasSubstr("Sealed.")) << "what was at work when it was stopped is not shown";
}

TEST(BlindTrial, IsShownInTheWindowUnlessUnsavedWorkIsKept) {
  OpenWindow open;
  changeField(open->document(), {.field = "title"}, "mine");
  QTest::keyClick(open.window.get(), Qt::Key_B, Qt::ControlModifier);
  auto* dialog = open->findChild<BlindTrialDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  dialog->findChild<QPushButton*>(QStringLiteral("draw"))->click();
  ASSERT_TRUE(waitFor([&] { return !dialog->job().isAtWork(); }));
  auto* inWindow = dialog->findChild<QPushButton*>(QStringLiteral("in window"));
  inWindow->click();
  EXPECT_EQ(open.dialogs->saveQuestions, 1);
  EXPECT_EQ(open->document().session().title, "mine") << "the question was answered by Cancel";
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  inWindow->click();
  EXPECT_EQ(open->document().session(), dialog->current()->trial.session);
  EXPECT_TRUE(open->document().path().isEmpty());
  EXPECT_TRUE(open->findChild<GapPanel*>()->isVisible());
}

TEST(TrialText, NamesEveryKind) {
  for (const TrialKind& kind : trialKinds())
    EXPECT_FALSE(trialKindName(kind.name).contains(u'_')) << kind.name;
  for (const TrialKind& kind : trialKinds()) {
    const BlindTrial trial = *drawBlindTrial({.protocol = "full", .kinds = {kind.name}}, seed);
    const QStringList lines = truthLines(trial);
    EXPECT_EQ(lines.front() == QStringLiteral("No error was simulated."), kind.name == "none") << kind.name;
  }
}

TEST(BlindTrial, ColoursTheScoreForTheThemeItIsReadIn) {
  TrialBench bench("full", "orientation_jump");
  bench.press("draw");
  bench.press("open seal");
  const auto labels = bench.dialog.findChildren<QLabel*>();
  const auto score = std::find_if(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text().startsWith(QStringLiteral("Right. "));
  });
  ASSERT_NE(score, labels.end());
  QPalette light = bench.dialog.palette(), dark = light;
  light.setColor(QPalette::Window, Qt::white);
  dark.setColor(QPalette::Window, QColor(0x20, 0x20, 0x20));
  for (const auto& role : {QPalette::Base, QPalette::Button}) {
    light.setColor(role, light.color(QPalette::Window));
    dark.setColor(role, dark.color(QPalette::Window));
  }
  ASSERT_NE(stateColor(light, State::Good), stateColor(dark, State::Good));
  for (const QPalette& palette : {dark, light}) {
    bench.dialog.setPalette(palette);
    EXPECT_EQ((*score)->palette().color(QPalette::WindowText), stateColor(palette, State::Good));
  }
}

}  // namespace
}  // namespace alidade::ui
