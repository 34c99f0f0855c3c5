#include "ui/panels/journal/change_reason_bar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include "core/statement/journal.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/hand_in.h"
#include "ui/commands/session_commands.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

class ChangeReasonBarTest : public ::testing::Test {
 protected:
  ChangeReasonBarTest() {
    open->document().startWithRecorded(paperSession());
    open.waitUntilIdle();
    open->hideStart();
    bar = open->findChild<ChangeReasonBar*>();
    line = bar->findChild<QLineEdit*>();
    table = open->findChild<PositionTabs*>()->table(0);
  }

  void correct(std::size_t row, const char* text) {
    ReadingsEditor(open->document(), 0).setCell({row, ReadingColumn::Horizontal}, text);
  }
  QString question() const { return bar->findChild<QLabel*>()->text(); }
  std::string whyPrinted(std::size_t row) {
    const Statement printed =
        journalTable(open->document().session(), {}, [](const JournalEntry&) { return std::string(); });
    return printed.rows.at(row).cells.at(2);
  }

  OpenWindow open;
  ChangeReasonBar* bar;
  QLineEdit* line;
  ReadingsTable* table;
};

TEST_F(ChangeReasonBarTest, AsksOnceARecordedReadingIsCorrectedAndPrintsTheReason) {
  EXPECT_TRUE(bar->isHidden());
  correct(4, "338 36 37");
  ASSERT_FALSE(bar->isHidden());
  EXPECT_THAT(question().toStdString(), HasSubstr("row 5"));
  bar->start();
  QTest::keyClicks(line, QStringLiteral("digits exchanged"));
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(bar->isHidden());
  EXPECT_EQ(whyPrinted(0), "retyped: digits exchanged");
  EXPECT_EQ(open->document().session().positions[0].readings[4].note, "") << "the note is the user's own";
  open->document().undoStack().undo();
  EXPECT_EQ(whyPrinted(0), "retyped");
  EXPECT_EQ(open->document().session().positions[0].readings[4].horizontal, "338 36 37");
}

TEST_F(ChangeReasonBarTest, TakesNoKeyFromThoseWhoGoOnTyping) {
  table->setFocus();
  table->selectCell(4, ReadingColumn::Horizontal);
  typeInto(*table, QStringLiteral("338 36 37"));
  EXPECT_FALSE(bar->isHidden());
  EXPECT_FALSE(line->hasFocus());
  typeInto(*table, QStringLiteral("80 53 01"));
  EXPECT_EQ(open->document().session().positions[0].readings[4].vertical, "80 53 01");
}

TEST_F(ChangeReasonBarTest, EscapeAndTheNextEditSkipIt) {
  correct(4, "338 36 37");
  bar->start();
  QTest::keyClicks(line, QStringLiteral("half"));
  QTest::keyClick(line, Qt::Key_Escape);
  EXPECT_TRUE(bar->isHidden());
  EXPECT_EQ(whyPrinted(0), "retyped");
  correct(5, "337 14 42");
  EXPECT_FALSE(bar->isHidden());
  ReadingsEditor(open->document(), 0).setExcluded({7}, true);
  EXPECT_TRUE(bar->isHidden()) << "an exclusion has a reason of its own";
}

TEST_F(ChangeReasonBarTest, ForgetsItsQuestionWithTheSession) {
  correct(4, "338 36 37");
  bar->start();
  QTest::keyClicks(line, QStringLiteral("half"));
  open->document().startNew();
  EXPECT_TRUE(bar->isHidden());
  bar->finish();
  EXPECT_TRUE(open->document().session().journal.empty()) << "it has no such entry";
}

TEST_F(ChangeReasonBarTest, AsksOfEveryFieldOnceTheSessionIsSealed) {
  changeField(open->document(), {.field = "title"}, "before");
  EXPECT_TRUE(bar->isHidden());
  open->document().push(new SealSession(open->document(), "R. Roe"));
  EXPECT_TRUE(bar->isHidden());
  EXPECT_THAT(open->windowTitle().toStdString(), HasSubstr("(sealed)"));
  changeField(open->document(), {.field = "title"}, "after");
  EXPECT_FALSE(bar->isHidden());
  EXPECT_THAT(open->windowTitle().toStdString(), HasSubstr("(changed since the seal)"));
}

/// A crash keeps what `HalfTyped` holds.
TEST_F(ChangeReasonBarTest, WhatIsTypedIsHalfTypedUntilItIsStated) {
  HalfTyped& halfTyped = open->document().halfTyped();
  ReadingsEditor(open->document(), 0).remove({2, 3});
  bar->start();
  QTest::keyClicks(line, QStringLiteral("cloud"));
  const Session before = open->document().session();
  const Session kept = withHandedIn(before, halfTyped.texts());
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(kept.journal.size(), before.journal.size() + 1);
  EXPECT_EQ(kept.journal.back().from, open->document().session().journal.back().from);
  EXPECT_EQ(kept.journal.back().to, "cloud");
  EXPECT_TRUE(halfTyped.isEmpty());
}

TEST_F(ChangeReasonBarTest, ANotStatedReasonIsHalfTypedNoMore) {
  correct(4, "338 36 37");
  bar->start();
  QTest::keyClicks(line, QStringLiteral("half"));
  EXPECT_FALSE(open->document().halfTyped().isEmpty());
  QTest::keyClick(line, Qt::Key_Escape);
  EXPECT_TRUE(open->document().halfTyped().isEmpty());
}

TEST_F(ChangeReasonBarTest, OneReasonIsOfAllThatWasChangedTogether) {
  ReadingsEditor(open->document(), 0).remove({2, 3});
  ASSERT_FALSE(bar->isHidden());
  EXPECT_THAT(question().toStdString(), HasSubstr("these 2 entries"));
  bar->start();
  QTest::keyClicks(line, QStringLiteral("cloud"));
  open->commitPending();
  EXPECT_EQ(whyPrinted(0), "deleted: cloud");
  EXPECT_EQ(whyPrinted(1), "deleted: cloud");
}

}  // namespace
}  // namespace alidade::ui
