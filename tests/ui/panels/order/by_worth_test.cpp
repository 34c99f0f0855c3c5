#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "core/answers/guidance_answer.h"
#include "core/session/protocol_progress.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/statement/sighting_choice.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/protocol_dialog.h"
#include "ui/entry/entry_guide.h"
#include "ui/main_window.h"
#include "ui/panels/order/order_panel.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/window/page_tabs.h"

// A session in which the next sighting is the most informative one.

namespace alidade::ui {
namespace {

using testing::HasSubstr;

Protocol fivePlaces() {
  return {.name = "five",
          .description = "",
          .points = 5,
          .first = Angle::fromDegrees(20),
          .step = Angle::fromDegrees(35),
          .rounds = 2,
          .faces = FacePlan::BothAtEachPlace};
}

/// Types the readings of a simulated session where F6 puts the focus, like a person at the instrument.
class ByWorth : public testing::Test {
 protected:
  ByWorth() : m_whole(*simulate(fivePlaces(), Truth(), 4)) {
    Session unread = m_whole;
    for (Position& position : unread.positions) {
      position.readings.clear();
      position.zero = {};
    }
    SightingProtocol protocol = templateOf(fivePlaces());
    for (ProtocolPosition& position : protocol.positions) position.zeros.before = {1};
    QApplication::setActiveWindow(m_open.window.get());
    m_open->document().startWith(unread);
    followProtocol(m_open->document(), openOrder(protocol));
    for (PageTabs* tabs : m_open->pageTabs())
      if (const int index = tabs->indexOf(m_open->findChild<OrderPanel*>()); index >= 0)
        tabs->showPage(index);
    waitUntilIdle();
  }

  const Session& session() { return m_open->document().session(); }
  void waitUntilIdle() {
    m_open.waitUntilIdle();
    QCoreApplication::processEvents();
  }
  OrderPanel& panel() { return *m_open->findChild<OrderPanel*>(); }
  QDoubleSpinBox& wanted() { return *panel().findChild<QDoubleSpinBox*>(); }
  void want(double uncertainty) {
    wanted().selectAll();
    typeInto(wanted(), QString::number(uncertainty), Qt::Key_Return);
  }
  /// The text of the page once nothing is being computed.
  std::string shown() {
    while (!panel().job().isIdle()) QTest::qWait(5);
    std::string text;
    for (const QLabel* label : panel().findChildren<QLabel*>())
      if (label->isVisible()) text += label->text().toStdString() + "\n";
    return text;
  }
  std::optional<PlannedSighting> next() {
    const auto protocol = *protocolOf(session());
    const ProtocolProgress progress = progressOf(session(), *protocol, m_open->document().chosenSighting());
    if (!progress.next) return {};
    return progress.sightings[*progress.next].planned;
  }
  /// Types the next sighting; false if the simulated session does not have it.
  bool typeNext() {
    const auto planned = next();
    if (!planned) return false;
    const Position& simulated = m_whole.positions[planned->axisDeg == 0 ? 0 : 1];
    std::string horizontal = simulated.zero.horizontal, vertical = simulated.zero.vertical;
    if (!planned->isZero) {
      const auto row = std::ranges::find_if(simulated.readings, [&](const Reading& reading) {
        return reading.point == std::to_string(planned->point) &&
               reading.round == std::to_string(planned->round) &&
               reading.face == std::to_string(planned->face);
      });
      if (row == simulated.readings.end()) return false;
      horizontal = row->horizontal;
      vertical = row->vertical;
    }
    m_open->entry().goToNextEntry();
    QCoreApplication::processEvents();
    typeInto(*QApplication::focusWidget(), QString::fromStdString(horizontal), Qt::Key_Return);
    typeInto(*QApplication::focusWidget(), QString::fromStdString(vertical), Qt::Key_Return);
    waitUntilIdle();
    return true;
  }
  QMenu* menu() {
    QMenu* menu =
        m_open->findChild<OrderPanel*>()->findChild<QToolButton*>(QStringLiteral("protocol choice"))->menu();
    emit menu->aboutToShow();
    return menu;
  }

  OpenWindow m_open;
  Session m_whole;
};

TEST_F(ByWorth, EveryReadingTypedIsTheOneThatWasNext) {
  for (int i = 0; i < 16; ++i) {
    const auto planned = next();
    ASSERT_TRUE(planned) << i;
    ASSERT_TRUE(typeNext()) << i;
    const auto protocol = *protocolOf(session());
    const ProtocolProgress progress = progressOf(session(), *protocol);
    const auto typed = std::ranges::find(progress.sightings, *planned, &FollowedSighting::planned);
    EXPECT_EQ(typed->state, SightingState::Taken) << i;
  }
  const ProtocolProgress progress = progressOf(session(), **protocolOf(session()));
  EXPECT_EQ(progress.taken, 16u);
  EXPECT_EQ(progress.unplanned + progress.missed + progress.outOfTurn, 0u);
}

TEST_F(ByWorth, TheTableStatusBarAndPageSayTheSameNext) {
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(typeNext());
  const auto planned = *next();
  const ReadingsTable* table = m_open->findChild<PositionTabs*>()->table(0);
  const auto point =
      table->model()->index(table->model()->rowCount() - 1, static_cast<int>(ReadingColumn::Point));
  EXPECT_EQ(point.data().toString().toInt(), planned.point);
  const auto text = m_open->findChild<QLabel*>(QStringLiteral("next sighting"))->text().toStdString();
  EXPECT_THAT(text, HasSubstr("point " + std::to_string(planned.point)));
}

TEST_F(ByWorth, IsSwitchedOffAndOnInTheMenu) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(typeNext());
  const auto action = [&] {
    for (QAction* entry : menu()->actions())
      if (entry->text() == QStringLiteral("Most Informative Next")) return entry;
    return static_cast<QAction*>(nullptr);
  };
  ASSERT_TRUE(action() && action()->isChecked());
  action()->trigger();
  waitUntilIdle();
  EXPECT_FALSE((*protocolOf(session()))->isByWorth);
  EXPECT_EQ((*protocolOf(session()))->positions.size(), 2u);
  EXPECT_FALSE(m_open->document().chosenSighting());
  EXPECT_FALSE(action()->isChecked());
  action()->trigger();
  waitUntilIdle();
  EXPECT_TRUE(m_open->document().chosenSighting());
  m_open->document().undoStack().undo();
  waitUntilIdle();
  EXPECT_FALSE(m_open->document().chosenSighting());
}

TEST_F(ByWorth, ListsTheSightingsThatReachAnUncertainty) {
  want(0.9);
  EXPECT_THAT(shown(), HasSubstr("once L, R0 and a reading are entered"));
  want(0);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(typeNext());
  EXPECT_THAT(shown(), HasSubstr("Enter the U of Δd")) << "the session has no tolerance";
  const auto expectAsConsole = [&](double uncertainty, const char* sentence) {
    want(uncertainty);
    ASSERT_EQ(wanted().value(), uncertainty);
    const std::string text = shown();
    EXPECT_THAT(text, HasSubstr(sentence));
    const Guidance console = guidanceOf(session(), **protocolOf(session()), uncertainty);
    const Statement statement = sightingsAheadStatement(*console.ahead, uncertainty);
    for (const std::string& said : statement.sentences) EXPECT_THAT(text, HasSubstr(said));
    for (const Statement::Row& row : statement.rows) EXPECT_THAT(text, HasSubstr(row.cells.back()));
  };
  expectAsConsole(0.9, "needs further sightings: ");
  expectAsConsole(0.001, "is not reached");
  EXPECT_THAT(shown(), HasSubstr("known"));
  expectAsConsole(90, "needs further sightings: ");
  for (int i = 0; i < 15; ++i) ASSERT_TRUE(typeNext());
  expectAsConsole(90, "already");
}

TEST_F(ByWorth, ReachesForAThirdOfTheToleranceUntilAnotherUIsTyped) {
  Session session = this->session();
  session.acceptance.toleranceMm = "0.6";
  m_open->document().startWith(session);
  waitUntilIdle();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(typeNext());
  EXPECT_DOUBLE_EQ(wanted().value(), 0.2);
  EXPECT_THAT(shown(), HasSubstr("U = 0.2 mm"));
  want(0.5);
  ASSERT_TRUE(typeNext());
  EXPECT_DOUBLE_EQ(wanted().value(), 0.5);
  want(0);
  EXPECT_DOUBLE_EQ(wanted().value(), 0.2);
  want(0.5);
  session.acceptance.toleranceMm = "0.0045";
  m_open->document().startWith(session);
  waitUntilIdle();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(typeNext());
  EXPECT_DOUBLE_EQ(wanted().value(), 0.0015) << "what was typed belonged to another session";
}

TEST_F(ByWorth, AsksForNoUncertaintyInAListedOrder) {
  EXPECT_TRUE(wanted().isVisible());
  followProtocol(m_open->document(), listedOrder(**protocolOf(session())));
  waitUntilIdle();
  EXPECT_FALSE(wanted().isVisible());
  followProtocol(m_open->document(), std::nullopt);
  waitUntilIdle();
  EXPECT_FALSE(wanted().isVisible());
}

TEST(ProtocolDialog, KeepsTheOrderByWorthAndItsMinutes) {
  SightingProtocol protocol = openOrder(templateOf(fivePlaces()));
  protocol.minutes.turningAxis = 12.25;
  ProtocolDialog dialog(protocol, CircleUnit::Dms);
  const auto kept = dialog.protocol();
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->isByWorth);
  EXPECT_EQ(kept->minutes, protocol.minutes);
  EXPECT_EQ(sightingCount(*kept), sightingCount(protocol));
  ProtocolDialog listed(listedOrder(protocol), CircleUnit::Dms);
  EXPECT_FALSE(listed.protocol()->isByWorth);
  EXPECT_EQ(listed.protocol()->minutes, protocol.minutes);
}

}  // namespace
}  // namespace alidade::ui
