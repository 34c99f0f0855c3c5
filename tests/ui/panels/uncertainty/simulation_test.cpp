#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocumentFragment>
#include <algorithm>
#include <cmath>

#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/commands/change_field.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/uncertainty/simulation_box.h"
#include "ui/text/quantity_text.h"
#include "ui/text/simulation_text.h"

// The budget page checks its uncertainty by Monte Carlo, for the current session.

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int draws = 2000;

/// A window with the paper's session and the page of the budget in front.
struct SimulationBench {
  SimulationBench() {
    open->files().open(samplePath(QStringLiteral("paper-table-1.alidade")));
    open.settle();
    QTest::keyClick(open.window.get(), Qt::Key_2, Qt::ControlModifier);
    box = open->findChild<SimulationBox*>();
    box->findChild<QSpinBox*>()->setValue(draws);
  }

  void press() { QTest::keyClick(box->findChild<QPushButton*>(), Qt::Key_Space); }
  bool finish() {
    return waitFor([this] { return !box->isWanted(); });
  }
  void run() {
    press();
    ASSERT_TRUE(finish());
  }
  /// The visible text: markup removed if interpreted.
  std::string shown() {
    QStringList texts;
    for (const QLabel* label : box->findChildren<QLabel*>())
      if (label->isVisibleTo(box))
        texts.append(label->textFormat() == Qt::RichText
                         ? QTextDocumentFragment::fromHtml(label->text()).toPlainText()
                         : label->text());
    return texts.join(u'\n').toStdString();
  }
  QString report() {
    QTemporaryDir folder;
    open.dialogs->reportPath = folder.filePath(QStringLiteral("report.pdf"));
    EXPECT_TRUE(open->files().exportReport());
    return printedText(open.dialogs->reportPath);
  }

  OpenWindow open;
  SimulationBox* box = nullptr;
};

TEST(Simulation, ShowsWhatTheCoreDrawsBesideWhatIsPropagated) {
  SimulationBench bench;
  EXPECT_THAT(bench.shown(), HasSubstr("Not checked yet."));
  bench.run();
  const Evaluation evaluation = evaluateFit(paperSession());
  const Intersection& linear = *evaluation.fit.intersection;
  const MonteCarlo check = *propagateDistributions(*evaluation.examined.measurement, evaluation.fit,
                                                   {.draws = draws, .threads = 1});
  const Spread& spread = *check.intersection;
  for (const double figure :
       {linear.value, linear.sigma, linear.value - linear.expanded, linear.value + linear.expanded,
        spread.mean, spread.sigma, spread.low, spread.high})
    EXPECT_THAT(bench.shown(), HasSubstr(numberText(figure, 4).toStdString()));
  EXPECT_THAT(bench.shown(), HasSubstr(agreementWord(check).toStdString()));
  EXPECT_THAT(bench.shown(), Not(HasSubstr("<"))) << "markup is not shown";
  // The arcs are nearly linear here, so the ends differ only by chance: 4 sigma of either, 1 in 8000.
  EXPECT_LT(std::max(check.lowDifference, check.highDifference), 4 * check.endpointSigma);
}

TEST(Simulation, IsStoppedByItsButtonAndByAnEdit) {
  SimulationBench bench;
  auto* count = bench.box->findChild<QSpinBox*>();
  count->setValue(count->maximum());
  auto* run = bench.box->findChild<QPushButton*>();
  bench.press();
  EXPECT_EQ(run->text(), QStringLiteral("Stop"));
  EXPECT_FALSE(count->isEnabled());
  ASSERT_TRUE(waitFor([&] { return bench.box->job().drawsMade() > 0; })) << "the window does not wait";
  bench.press();
  ASSERT_TRUE(bench.finish());
  EXPECT_LT(bench.box->job().drawsMade(), static_cast<std::size_t>(count->maximum()));
  EXPECT_THAT(bench.shown(), HasSubstr("Stopped."));
  EXPECT_EQ(run->text(), QStringLiteral("Run"));

  bench.press();
  changeField(bench.open->document(), {.field = "geometry.distance_mm"}, "2406");
  ASSERT_TRUE(bench.finish());
  bench.open.settle();
  EXPECT_THAT(bench.shown(), HasSubstr("Stopped, for the session has changed."));
  EXPECT_FALSE(bench.report().contains(QStringLiteral("Monte Carlo (JCGM")));
}

TEST(Simulation, GoesOnUntilWhatItIsOfHasChanged) {
  SimulationBench bench;
  auto* count = bench.box->findChild<QSpinBox*>();
  count->setValue(count->maximum());
  bench.press();
  changeField(bench.open->document(), {.field = "operator"}, "M. Ruiz");
  bench.open.settle();
  EXPECT_TRUE(bench.box->job().isAtWork()) << "nothing that enters a fit has changed";
  bench.press();
  ASSERT_TRUE(bench.finish());
}

TEST(Simulation, WaitsForTheFitOfWhatWasJustTyped) {
  SimulationBench bench;
  ReadingsTable& readings = *bench.open->currentTable();
  readings.setCurrentIndex(readings.model()->index(2, static_cast<int>(ReadingColumn::Vertical)));
  typeInto(readings, QStringLiteral("84 53 12"));
  const Session typed = bench.open->document().session();
  ASSERT_FALSE(bench.open->job().isIdle());
  bench.press();
  EXPECT_FALSE(bench.box->job().isAtWork()) << "what is shown is the fit before";
  EXPECT_EQ(bench.box->findChild<QPushButton*>()->text(), QStringLiteral("Stop"));
  ASSERT_TRUE(bench.finish());
  const Evaluation evaluation = evaluateFit(typed);
  const MonteCarlo check = *propagateDistributions(*evaluation.examined.measurement, evaluation.fit,
                                                   {.draws = draws, .threads = 1});
  EXPECT_THAT(bench.shown(), HasSubstr(numberText(check.intersection->low, 4).toStdString()));
  EXPECT_THAT(bench.shown(), HasSubstr(numberText(check.intersection->high, 4).toStdString()));
}

TEST(Simulation, DoesNotWaitWhereThereIsNothingToSimulateOrItIsStopped) {
  SimulationBench bench;
  changeField(bench.open->document(), {.field = "geometry.distance_mm"}, "2406");
  bench.press();
  bench.press();
  bench.open.settle();
  EXPECT_FALSE(bench.box->isWanted()) << "pressed again is stopped";
  EXPECT_THAT(bench.shown(), HasSubstr("Stopped."));

  changeField(bench.open->document(), {.field = "geometry.distance_mm"}, "");
  bench.press();
  bench.open.settle();
  EXPECT_FALSE(bench.box->isWanted()) << "without a distance there is no intersection";
  changeField(bench.open->document(), {.field = "geometry.distance_mm"}, "2405");
  bench.open.settle();
  EXPECT_FALSE(bench.box->isWanted());
}

TEST(Simulation, IsToldOnPaperOfTheSessionItIsOf) {
  SimulationBench bench;
  EXPECT_FALSE(bench.report().contains(QStringLiteral("Monte Carlo (JCGM")));
  bench.run();
  changeField(bench.open->document(), {.field = "operator"}, "M. Ruiz");
  bench.open.settle();
  EXPECT_THAT(bench.shown(), HasSubstr("simulated")) << "nothing that enters a fit has changed";
  EXPECT_TRUE(
      bench.report().contains(QStringLiteral("Monte Carlo (JCGM 101, 2000 draws) of Δd, fit only: ")));

  ReadingsEditor(bench.open->document(), 1).setExcluded({3}, true);
  bench.open.settle();
  EXPECT_THAT(bench.shown(), Not(HasSubstr("simulated")));
  EXPECT_FALSE(bench.report().contains(QStringLiteral("Monte Carlo (JCGM")));
  bench.open->undo();
  bench.open.settle();
  EXPECT_THAT(bench.shown(), HasSubstr("simulated")) << "back where it was run";
}

/// A thousand draws and a tolerance of 0.005 mm.
MonteCarlo differing(double low, LinearPropagation linear) {
  MonteCarlo check;
  check.draws = 1000;
  check.tolerance = 0.005;
  check.lowDifference = low;
  check.highDifference = 0.002;
  check.endpointSigma = 0.004;
  check.linear = linear;
  return check;
}

TEST(Simulation, SaysWhatFollows) {
  MonteCarlo check = differing(0.031, LinearPropagation::Refuted);
  EXPECT_EQ(agreementSentence(check).toStdString(),
            "The ends of Δd ± U differ from those simulated by 0.0310 and 0.0020 mm; the tolerance is 0.0050 "
            "mm. Rely on the simulated interval.");
  check.failed = 1;
  EXPECT_THAT(agreementSentence(check).toStdString(), HasSubstr("Draws without a result, left out: 1."));
}

TEST(Simulation, SaysHowManyDrawsWouldTell) {
  MonteCarlo check = differing(0.003, LinearPropagation::Undecided);
  EXPECT_EQ(agreementWord(check), QStringLiteral("No disagreement, but too few draws to be sure."));
  EXPECT_THAT(agreementSentence(check).toStdString(),
              HasSubstr("an end is uncertain by 0.0040 mm: about 6000 draws would tell."))
      << "1000 · (3 · 0.004/0.005)²";
  check.lowDifference = 0.0091;
  EXPECT_EQ(agreementWord(check), QStringLiteral("Too few draws to tell."));
  EXPECT_THAT(agreementSentence(check).toStdString(), HasSubstr(": about 9000 draws would tell."))
      << "1000 · (3 · 0.004/(0.0091 − 0.005))²";
  check.lowDifference = 0.016;
  EXPECT_THAT(agreementSentence(check).toStdString(), HasSubstr(": about 6000 draws would tell."))
      << "the tolerance is the smaller room";
  check.lowDifference = check.tolerance;
  EXPECT_EQ(agreementWord(check), QStringLiteral("No disagreement, but too few draws to be sure."));
  EXPECT_THAT(agreementSentence(check).toStdString(), HasSubstr(": about 6000 draws would tell."))
      << "at the tolerance is within it";
  check.lowDifference = std::nextafter(check.tolerance, 1);
  EXPECT_THAT(agreementSentence(check).toStdString(),
              HasSubstr("; it would take more draws than can be asked for here to tell."));
}

}  // namespace
}  // namespace alidade::ui
