#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_positions.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/dialogs/file_flow.h"
#include "ui/entry/readings_finder.h"
#include "ui/main_window.h"
#include "ui/panels/readings/find_bar.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/window/entry_column.h"

// The duties of any desktop program, without loss of readings.

namespace alidade::ui {
namespace {

using testing::Each;
using testing::Field;

TEST(Revert, BringsBackTheFileAndUndoWhatWasTyped) {
  const QTemporaryDir folder;
  OpenWindow open;
  open->document().startWith(paperSession());
  open.dialogs->savePath = folder.filePath(QStringLiteral("a.alidade"));
  ASSERT_TRUE(open->files().save());
  EXPECT_FALSE(open->files().revert()) << "nothing was changed";
  changeField(open->document(), {.field = "geometry.distance_mm"}, "2406");
  const Session typed = open->document().session();
  ASSERT_TRUE(open->files().revert());
  EXPECT_EQ(open->document().session(), *loadSession(open.dialogs->savePath.toStdString()));
  EXPECT_FALSE(open->document().isModified());
  open->undo();
  EXPECT_EQ(open->document().session(), typed);
  EXPECT_TRUE(open->document().isModified());
}

TEST(Revert, TellsWhereTheFileIsGone) {
  const QTemporaryDir folder;
  OpenWindow open;
  open->document().startWith(paperSession());
  open.dialogs->savePath = folder.filePath(QStringLiteral("a.alidade"));
  ASSERT_TRUE(open->files().save());
  changeField(open->document(), {.field = "title"}, "kept");
  QFile::remove(open.dialogs->savePath);
  EXPECT_FALSE(open->files().revert());
  EXPECT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_EQ(open->document().session().title, "kept");
}

TEST(RemovePosition, TakesAllOfItAndUndoBringsItBack) {
  for (const std::size_t position : {0U, 1U, 2U}) {
    OpenWindow open;
    const Session before = sessionTakenAt({0, 180, 0});
    open->document().startWith(before);
    removePosition(open->document(), position);
    open.waitUntilIdle();
    Session after = before;
    after.positions.erase(after.positions.begin() + static_cast<std::ptrdiff_t>(position));
    EXPECT_EQ(open->document().session().positions, after.positions);
    EXPECT_THAT(open->document().session().journal, Each(Field(&JournalEntry::why, "deleted")));
    EXPECT_FALSE(open->document().session().journal.empty()) << "readings that stood are gone";
    open->undo();
    open.waitUntilIdle();
    EXPECT_EQ(open->document().session(), before) << "never saved, so without a trace";
  }
}

TEST(RemovePosition, ThatWasSavedIsToldWhenItComesBack) {
  const QTemporaryDir folder;
  OpenWindow open;
  open->document().startWith(paperSession());
  removePosition(open->document(), 1);
  open.dialogs->savePath = folder.filePath(QStringLiteral("a.alidade"));
  ASSERT_TRUE(open->files().save());
  const std::size_t recorded = open->document().session().journal.size();
  open->undo();
  EXPECT_EQ(open->document().session().positions, paperSession().positions);
  EXPECT_GE(open->document().session().journal.size(), 2 * recorded);
}

TEST(MoveRows, TakesThemToTheOtherPositionInOneStep) {
  SessionDocument document;
  document.startWith(paperSession());
  moveRows(document, 0, {3, 5, 99}, 1);
  const auto& positions = document.session().positions;
  ASSERT_EQ(positions[0].readings.size(), 15U);
  ASSERT_EQ(positions[1].readings.size(), 19U);
  EXPECT_EQ(positions[1].readings[17].horizontal, paperSession().positions[0].readings[3].horizontal);
  EXPECT_EQ(positions[1].readings[18].horizontal, paperSession().positions[0].readings[5].horizontal);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.session(), paperSession());
  moveRows(document, 0, {99}, 1);
  moveRows(document, 0, {0}, 0);
  moveRows(document, 0, {0}, 7);
  EXPECT_EQ(document.session(), paperSession());
}

TEST(FindInReadings, GoesRoundTheSessionEitherWay) {
  const Session session = paperSession();
  const auto find = [&](const Place& from, const char* text, bool forward = true) {
    const auto place = findInReadings(session, from, QString::fromUtf8(text), forward);
    return place ? place->path() : std::string("nowhere");
  };
  const Place start{.position = 0, .reading = 0, .field = "point"};
  EXPECT_EQ(find(start, "3415522"), "positions[1].readings[0].horizontal") << "341°55'22\", by its digits";
  EXPECT_EQ(find(start, "341°55"), "positions[1].readings[0].horizontal");
  EXPECT_EQ(find(start, "341 5"), "positions[0].readings[0].horizontal");
  const Place there{.position = 0, .reading = 0, .field = "horizontal"};
  EXPECT_EQ(find(there, "341 5"), "positions[1].readings[0].horizontal") << "the next one";
  EXPECT_EQ(find(there, "341 5", false), "positions[1].readings[0].horizontal") << "round the beginning";
  EXPECT_EQ(find(there, "341 52"), "positions[0].readings[0].horizontal") << "the only one, again";
  EXPECT_EQ(find(start, "no such note"), "nowhere");
  EXPECT_EQ(find(start, ""), "nowhere");
  EXPECT_FALSE(findInReadings(blankSession(), {}, QStringLiteral("1"), true));
}

TEST(FindInReadings, FindsNotesWhateverTheirCase) {
  Session session = paperSession();
  session.positions[1].readings[4].note = "Stützpunkt Ünsicher";
  const auto place = findInReadings(session, {}, QStringLiteral("ünsich"), true);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->path(), "positions[1].readings[4].note");
}

TEST(FindBar, LeadsToWhatIsTypedAndBackToTheTable) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  open->entries().finder().find();
  auto* line = open->findChild<QLineEdit*>(QStringLiteral("find"));
  ASSERT_TRUE(line->isVisible());
  typeInto(*line, QStringLiteral("98 57"));
  EXPECT_EQ(open->currentTable()->readings().position(), 1U);
  EXPECT_EQ(open->currentTable()->currentIndex().row(), 6);
  QTest::keyClick(line, Qt::Key_Escape);
  EXPECT_FALSE(line->isVisible());
  EXPECT_EQ(QApplication::focusWidget(), open->currentTable());
}

}  // namespace
}  // namespace alidade::ui
