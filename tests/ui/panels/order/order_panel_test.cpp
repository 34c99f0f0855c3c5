#include "ui/panels/order/order_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QScrollBar>
#include <QTest>
#include <QToolButton>

#include "core/base/angle_text.h"
#include "core/session/protocol_progress.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/dialogs/protocol_dialog.h"
#include "ui/entry/entry_guide.h"
#include "ui/main_window.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

/// A window with the page in front.
struct OrderBench {
  OpenWindow open;

  OrderBench() {
    QApplication::setActiveWindow(open.window.get());
    for (PageTabs* tabs : open->pageTabs())
      if (const int index = tabs->indexOf(&panel()); index >= 0) tabs->showPage(index);
  }

  OrderPanel& panel() { return *open->findChild<OrderPanel*>(); }
  std::string text(const char* name) {
    return panel().findChild<QLabel*>(QLatin1String(name))->text().toStdString();
  }
  void waitUntilIdle() {
    open.waitUntilIdle();
    while (!panel().job().isIdle()) QTest::qWait(5);
    QCoreApplication::processEvents();
  }
  void choose(const QString& name) {
    QMenu* menu = panel().findChild<QToolButton*>(QStringLiteral("protocol choice"))->menu();
    emit menu->aboutToShow();
    for (QAction* action : menu->actions())
      if (action->text() == name || action->objectName() == name) return action->trigger();
    ADD_FAILURE() << name.toStdString();
  }
  const Session& session() { return open->document().session(); }
};

Protocol shortPlan() {
  return {.name = "short",
          .description = "",
          .points = 3,
          .first = Angle::fromDegrees(30),
          .step = Angle::fromDegrees(60),
          .rounds = 2,
          .faces = FacePlan::BothAtEachPlace};
}

/// A new session: lengths without readings.
Session unread(Session session) {
  for (Position& position : session.positions) {
    position.readings.clear();
    position.zero = {};
  }
  return session;
}

/// Follows the keyboard through a whole protocol: zeros in both faces, both ways, both positions.
TEST(OrderPanel, LeadsTheKeyboardThroughAWholeProtocol) {
  Truth truth;
  truth.intersection = 0.5;
  const Session whole = *simulate(shortPlan(), truth, 4);
  const SightingProtocol protocol = templateOf(shortPlan());
  OrderBench bench;
  bench.open->document().startWith(unread(whole));
  followProtocol(bench.open->document(), protocol);
  bench.waitUntilIdle();
  const std::size_t count = sightingsInOrder(protocol).size();
  ASSERT_EQ(count, 28u);
  for (std::size_t i = 0; i < count; ++i) {
    const auto progress = progressIn(bench.session());
    ASSERT_TRUE(progress && progress->next) << i;
    const FollowedSighting& next = progress->sightings[*progress->next];
    bench.open->entry().goToNextEntry();
    QCoreApplication::processEvents();
    QWidget* focus = QApplication::focusWidget();
    ASSERT_TRUE(focus);
    const PlannedSighting& planned = next.planned;
    std::string horizontal, vertical;
    if (planned.isZero) {
      EXPECT_THAT(focus->objectName().toStdString(), HasSubstr(zeroField(planned) + ".horizontal")) << i;
      const PointingZero& zero = whole.positions[*next.position].zero;
      const Angle turned = Angle::fromDegrees(planned.face == 2 ? 180 : 0);
      horizontal = formatDms(wrapped(*parseAngle(zero.horizontal) + turned, Angle::fromDegrees(180)), 1,
                             AngleSigns::Typewriter);
      vertical = planned.face == 2 ? formatDms(Angle::fromDegrees(360) - *parseAngle(zero.vertical), 1,
                                               AngleSigns::Typewriter)
                                   : zero.vertical;
    } else {
      EXPECT_EQ(focus->objectName().toStdString(), "readings" + std::to_string(*next.position)) << i;
      for (const Reading& row : whole.positions[*next.position].readings)
        if (row.point == std::to_string(planned.point) && row.round == std::to_string(planned.round) &&
            row.face == std::to_string(planned.face)) {
          horizontal = row.horizontal;
          vertical = row.vertical;
        }
    }
    ASSERT_FALSE(horizontal.empty()) << i;
    typeInto(*focus, qText(horizontal), Qt::Key_Return);
    typeInto(*QApplication::focusWidget(), qText(vertical), Qt::Key_Return);
    QCoreApplication::processEvents();
  }
  bench.waitUntilIdle();
  const ProtocolProgress progress = progressOf(bench.session(), protocol);
  EXPECT_FALSE(progress.next);
  EXPECT_TRUE(progress.isComplete());
  EXPECT_EQ(progress.outOfTurn + progress.unplanned + progress.missed, 0u);
  EXPECT_THAT(bench.text("order state"), HasSubstr("28 of 28"));
  EXPECT_THAT(bench.text("next sighting"), HasSubstr("The protocol is complete"));
  EXPECT_THAT(bench.text("order outlook"), HasSubstr("Further rounds do not reduce"));
}

/// Enter alone: the further zeros that are shown do not catch it.
TEST(OrderPanel, EnterLeadsFromAZeroToTheNextSighting) {
  const Session whole = *simulate(shortPlan(), Truth(), 4);
  SightingProtocol protocol = templateOf(shortPlan());
  for (ProtocolPosition& position : protocol.positions) position.zeros.before = {1, 2};
  OrderBench bench;
  bench.open->document().startWith(unread(whole));
  followProtocol(bench.open->document(), protocol);
  bench.waitUntilIdle();
  const auto typeZero = [&](const char* field) {
    const QString name = QStringLiteral("pointing_zero%1.%2 0").arg(QLatin1String(field));
    EXPECT_EQ(QApplication::focusWidget()->objectName(), name.arg(QLatin1String("horizontal")));
    typeInto(*QApplication::focusWidget(), QStringLiteral("12 0 0"));
    EXPECT_EQ(QApplication::focusWidget()->objectName(), name.arg(QLatin1String("vertical")));
    typeInto(*QApplication::focusWidget(), QStringLiteral("90 0 0"));
    QCoreApplication::processEvents();
  };
  bench.open->entry().goToNextEntry();
  typeZero("");
  typeZero(".face_2");
  EXPECT_EQ(QApplication::focusWidget()->objectName(), QStringLiteral("readings0"));
}

TEST(OrderPanel, SaysWhatIsNextAndHowFarItIs) {
  OrderBench bench;
  bench.open->document().startWith(paperSession());
  bench.choose(QStringLiteral("there-and-back"));
  bench.waitUntilIdle();
  EXPECT_THAT(bench.text("order state"), HasSubstr("36 of 70"));
  EXPECT_THAT(bench.text("next sighting"), HasSubstr("point 17, round 2"));
  EXPECT_THAT(bench.text("expected reading"), HasSubstr("323°07′"));
  EXPECT_THAT(bench.text("order outlook"), HasSubstr("the verdict"));
  EXPECT_THAT(bench.panel().findChild<QProgressBar*>()->format().toStdString(), HasSubstr("of 70"));
  EXPECT_EQ(bench.panel().findChild<DataTable*>()->model()->rowCount(), 70);
}

/// |Δd| is 0.1 mm below the tolerance, and effects that are equal in all rounds add more than that to U.
TEST(OrderPanel, NamesWhatHelpsIfRoundsDoNot) {
  Truth truth;
  truth.intersection = 0.5;
  Session session = *simulateWithoutNoise(shortPlan(), truth, 4);
  session.acceptance.toleranceMm = "0.6";
  OrderBench bench;
  bench.open->document().startWith(session);
  followProtocol(bench.open->document(), templateOf(shortPlan()));
  bench.waitUntilIdle();
  EXPECT_THAT(bench.text("order outlook"), HasSubstr("More rounds are not enough"));
  std::string shown;
  for (const QLabel* label : bench.panel().findChildren<QLabel*>())
    if (label->isVisible()) shown += label->text().toStdString() + "\n";
  EXPECT_THAT(shown, HasSubstr("What to measure next\n"));
  EXPECT_THAT(shown, HasSubstr("min, about\nU (mm)\n"));
}

TEST(OrderPanel, ListsTheNextSightingInView) {
  OrderBench bench;
  bench.open->document().startWith(paperSession());
  bench.choose(QStringLiteral("there-and-back"));
  auto* table = bench.panel().findChild<DataTable*>();
  const auto expectListed = [&](int row) {
    bench.waitUntilIdle();
    EXPECT_EQ(bench.panel().findChild<QProgressBar*>()->format(),
              QStringLiteral("sighting %1 of 70").arg(row + 1));
    const QModelIndex next = table->model()->index(row, 0);
    EXPECT_TRUE(table->selectionModel()->isRowSelected(row));
    EXPECT_TRUE(table->viewport()->rect().contains(table->visualRect(next).center())) << row;
  };
  expectListed(53);  // after 35 at 0°, the zero and 17 places
  ReadingsEditor(bench.open->document(), 1).remove({15, 16});
  expectListed(51);
  table->scrollToBottom();
  const int looked = table->verticalScrollBar()->value();
  ASSERT_GT(looked, 0);
  ReadingsEditor(bench.open->document(), 0).setCell({0, ReadingColumn::Note}, "windy");
  bench.waitUntilIdle();
  EXPECT_EQ(table->verticalScrollBar()->value(), looked) << "the same is next";
}

TEST(OrderPanel, IsUndoneInOneStepAndLeavesTheFileAsItWas) {
  OrderBench bench;
  bench.open->document().startWith(paperSession());
  bench.choose(QStringLiteral("full-again"));
  EXPECT_EQ(bench.session().positions.size(), 3u) << "0° is measured again";
  EXPECT_FALSE(bench.session().protocol.empty());
  bench.open->undo();
  EXPECT_EQ(bench.session(), paperSession());
  bench.open->redo();
  bench.choose(QStringLiteral("None"));
  EXPECT_TRUE(bench.session().protocol.empty());
}

TEST(OrderPanel, GoesOnAfterAReadingOffTheOrder) {
  OrderBench bench;
  Session session = paperSession();
  session.positions[1].readings.clear();
  session.positions[1].zero = {};
  session.positions[0].readings.erase(session.positions[0].readings.begin() + 4);
  bench.open->document().startWith(session);
  bench.choose(QStringLiteral("paper"));
  bench.waitUntilIdle();
  EXPECT_THAT(bench.text("next sighting"), HasSubstr("point 5"));
}

TEST(OrderPanel, TellsOfAProtocolThatMeansNothing) {
  OrderBench bench;
  Session session = paperSession();
  session.protocol = "{\"positions\": [{\"axis_deg\": 90}]}";
  bench.open->document().startWith(session);
  bench.waitUntilIdle();
  EXPECT_THAT(bench.text("order state"), HasSubstr("protocol.positions[0].axis_deg"));
}

TEST(ProtocolDialog, GivesBackWhatItWasGiven) {
  for (const char* name : {"paper", "there-and-back", "full", "shifted-circle", "again"}) {
    SightingProtocol protocol = *templateNamed(name);
    const ProtocolDialog dialog(protocol, CircleUnit::Dms);
    ASSERT_TRUE(dialog.protocol()) << name;
    EXPECT_EQ(*dialog.protocol(), protocol) << name;
  }
}

}  // namespace
}  // namespace alidade::ui
