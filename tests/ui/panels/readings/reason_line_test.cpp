#include "ui/panels/readings/reason_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTest>

#include "core/statement/journal.h"
#include "tests/ui/support.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/hand_in.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {
namespace {

class ReasonLineTest : public ::testing::Test {
 protected:
  ReasonLineTest() {
    open->document().startWithRecorded(paperSession());
    open.waitUntilIdle();
    open->hideStart();
    table = open->findChild<PositionTabs*>()->table(0);
    table->setFocus();
    line = table->findChild<ReasonLine*>();
  }

  void exclude(int row) {
    table->selectCell(row, ReadingColumn::Horizontal);
    QTest::keyClick(table, Qt::Key_Space);
  }
  const Reading& row(std::size_t index) const {
    return open.window->document().session().positions[0].readings[index];
  }

  OpenWindow open;
  ReadingsTable* table;
  ReasonLine* line;
};

TEST_F(ReasonLineTest, TakesTheReasonWhereTheRowIsExcluded) {
  exclude(4);
  ASSERT_TRUE(line->isVisible());
  EXPECT_TRUE(line->hasFocus());
  EXPECT_TRUE(row(4).excluded) << "at once";
  QTest::keyClicks(line, QStringLiteral("tripod touched"));
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_FALSE(line->isVisible());
  EXPECT_TRUE(table->hasFocus());
  EXPECT_EQ(table->currentIndex(), table->model()->index(4, static_cast<int>(ReadingColumn::Horizontal)));
  EXPECT_EQ(row(4).note, "tripod touched");
  open->document().undoStack().undo();
  EXPECT_EQ(row(4).note, "");
  EXPECT_TRUE(row(4).excluded);
}

TEST_F(ReasonLineTest, ReturnAndEscapeSkipIt) {
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
    exclude(3);
    if (key == Qt::Key_Escape) QTest::keyClicks(line, QStringLiteral("half"));
    QTest::keyClick(line, key);
    EXPECT_FALSE(line->isVisible());
    EXPECT_TRUE(row(3).excluded);
    EXPECT_EQ(row(3).note, "");
    QTest::keyClick(table, Qt::Key_Space);
    EXPECT_FALSE(row(3).excluded);
    EXPECT_FALSE(line->isVisible()) << "a row used again needs no reason";
  }
}

TEST_F(ReasonLineTest, AnEmptyLineLetsArrowsAndSpaceThrough) {
  exclude(3);
  QTest::keyClick(line, Qt::Key_Space);
  EXPECT_FALSE(row(3).excluded) << "used again";
  exclude(3);
  QTest::keyClick(line, Qt::Key_Down);
  EXPECT_EQ(table->currentIndex().row(), 4);
  EXPECT_TRUE(table->hasFocus());
}

TEST_F(ReasonLineTest, AReasonIsAddedToANoteAndToEachRow) {
  ReadingsEditor(open->document(), 0).setCell({5, ReadingColumn::Note}, "hazy");
  table->selectCell(5, ReadingColumn::Horizontal);
  table->selectionModel()->select(table->model()->index(6, 0),
                                  QItemSelectionModel::Select | QItemSelectionModel::Rows);
  QTest::keyClick(table, Qt::Key_Space);
  QTest::keyClicks(line, QStringLiteral("cloud"));
  open->commitPending();
  EXPECT_EQ(row(5).note, "hazy; cloud");
  EXPECT_EQ(row(6).note, "cloud");
}

/// A crash keeps what `HalfTyped` holds.
TEST_F(ReasonLineTest, WhatIsTypedIsHalfTypedUntilItIsGiven) {
  HalfTyped& halfTyped = open->document().halfTyped();
  ReadingsEditor(open->document(), 0).setCell({4, ReadingColumn::Note}, "hazy");
  exclude(4);
  EXPECT_TRUE(halfTyped.isEmpty());
  QTest::keyClicks(line, QStringLiteral("cloud"));
  const Session kept = withHandedIn(open->document().session(), halfTyped.texts());
  EXPECT_EQ(row(4).note, "hazy");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(kept.positions[0].readings[4].note, "hazy; cloud");
  EXPECT_EQ(row(4).note, "hazy; cloud");
  EXPECT_TRUE(halfTyped.isEmpty());
}

TEST_F(ReasonLineTest, JournalPrintsTheReason) {
  exclude(4);
  QTest::keyClicks(line, QStringLiteral("tripod touched"));
  QTest::keyClick(line, Qt::Key_Return);
  const Session& session = open->document().session();
  ASSERT_EQ(session.journal.size(), 1u) << "the note itself is no observation";
  const Statement printed = journalTable(session, {}, [](const JournalEntry&) { return std::string(); });
  std::string cells;
  for (const auto& cell : printed.rows[0].cells) cells += testing::PrintToString(cell);
  EXPECT_THAT(cells, testing::HasSubstr("excluded: tripod touched"));
}

TEST_F(ReasonLineTest, StaysWithinTheTable) {
  for (const int at : {0, 8, 16}) {
    exclude(at);
    EXPECT_TRUE(table->viewport()->rect().contains(line->geometry())) << at;
    EXPECT_FALSE(line->geometry().intersects(table->visualRect(table->model()->index(at, 0)))) << at;
    QTest::keyClick(line, Qt::Key_Return);
  }
}

}  // namespace
}  // namespace alidade::ui
