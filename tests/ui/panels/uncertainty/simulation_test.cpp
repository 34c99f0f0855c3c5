#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/statement/budget.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/uncertainty/simulation_box.h"
#include "ui/text/quantity_text.h"

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
    open.waitUntilIdle();
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
  std::string shown() {
    QStringList texts;
    for (const QLabel* label : box->findChildren<QLabel*>())
      if (label->isVisibleTo(box)) texts.append(label->text());
    return texts.join(u'\n').toStdString();
  }
  QString report() {
    QTemporaryDir folder;
    open.dialogs->reportPath = folder.filePath(QStringLiteral("report.pdf"));
    EXPECT_TRUE(open->files().exportReport());
    return printedText(open.dialogs->reportPath).simplified();  // wherever a line ends
  }

  OpenWindow open;
  SimulationBox* box = nullptr;
};

TEST(Simulation, ShowsWhatTheCoreDrawsBesideWhatIsPropagated) {
  SimulationBench bench;
  EXPECT_THAT(bench.shown(), HasSubstr("has not been checked yet."));
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
  EXPECT_THAT(bench.shown(), HasSubstr(agreementWord(check)));
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
  bench.open.waitUntilIdle();
  EXPECT_THAT(bench.shown(), HasSubstr("Stopped, because the session has changed."));
  EXPECT_FALSE(bench.report().contains(QStringLiteral("JCGM 101: ")));
}

TEST(Simulation, GoesOnUntilWhatItIsOfHasChanged) {
  SimulationBench bench;
  auto* count = bench.box->findChild<QSpinBox*>();
  count->setValue(count->maximum());
  bench.press();
  changeField(bench.open->document(), {.field = "operator"}, "M. Ruiz");
  bench.open.waitUntilIdle();
  EXPECT_TRUE(bench.box->job().isAtWork()) << "nothing that enters a fit has changed";
  bench.press();
  ASSERT_TRUE(bench.finish());
}

TEST(Simulation, IsOfNoOtherTemperatureCompensatorOrEffect) {
  const Session session = paperSession();
  const auto isOther = [&](const auto& change) {
    Session other = session;
    change(other);
    return !measuresAlike(session, other);
  };
  EXPECT_TRUE(isOther([](Session& other) { other.environment.temperatureC = "35"; }));
  EXPECT_TRUE(isOther([](Session& other) { other.instrument.sigmaCompensatorArcsec = "3"; }));
  EXPECT_TRUE(isOther([](Session& other) { other.instrument.lineOfSight.offsetMm = "0.1"; }));
  EXPECT_TRUE(isOther([](Session& other) { other.ownEffects.emplace_back(); }));
  EXPECT_TRUE(isOther([](Session& other) { other.acceptance.coverage = "0.99"; }));
  EXPECT_FALSE(isOther([](Session& other) { other.acceptance.toleranceMm = "0.1"; }));
  EXPECT_FALSE(isOther([](Session& other) { other.title = "again"; }));
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
  bench.open.waitUntilIdle();
  EXPECT_FALSE(bench.box->isWanted()) << "pressed again is stopped";
  EXPECT_THAT(bench.shown(), HasSubstr("Stopped."));

  changeField(bench.open->document(), {.field = "geometry.distance_mm"}, "");
  bench.press();
  bench.open.waitUntilIdle();
  EXPECT_FALSE(bench.box->isWanted()) << "without a distance there is no intersection";
  changeField(bench.open->document(), {.field = "geometry.distance_mm"}, "2405");
  bench.open.waitUntilIdle();
  EXPECT_FALSE(bench.box->isWanted());
}

TEST(Simulation, IsToldOnPaperOfTheSessionItIsOf) {
  SimulationBench bench;
  EXPECT_FALSE(bench.report().contains(QStringLiteral("JCGM 101: ")));
  bench.run();
  changeField(bench.open->document(), {.field = "operator"}, "M. Ruiz");
  bench.open.waitUntilIdle();
  EXPECT_THAT(bench.shown(), HasSubstr("simulated")) << "nothing that enters a fit has changed";
  EXPECT_TRUE(bench.report().contains(QStringLiteral("JCGM 101: 2000 draws of all readings")));

  ReadingsEditor(bench.open->document(), 1).setExcluded({3}, true);
  bench.open.waitUntilIdle();
  EXPECT_THAT(bench.shown(), Not(HasSubstr("simulated")));
  EXPECT_FALSE(bench.report().contains(QStringLiteral("JCGM 101: ")));
  bench.open->undo();
  bench.open.waitUntilIdle();
  EXPECT_THAT(bench.shown(), HasSubstr("simulated")) << "back where it was run";
}

}  // namespace
}  // namespace alidade::ui
