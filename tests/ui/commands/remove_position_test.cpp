#include "ui/commands/change_positions.h"

#include <gmock/gmock.h>

#include <QAction>
#include <QMenuBar>

#include "tests/ui/support.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/panels/readings/position_tabs.h"

namespace alidade::ui {
namespace {

/// The position is removed before any reading, after a single row, and when complete.
TEST(RemovePosition, TakesAsManyRowsAsThereAreAndBringsThemBack) {
  for (const std::size_t rows : {0u, 1u, 2u, 17u}) {
    Session session = paperSession();
    session.positions[1].readings.resize(rows);
    SessionDocument document;
    document.startWith(session);
    removePosition(document, 1);
    EXPECT_EQ(document.session().positions.size(), 1u) << rows;
    document.undoStack().undo();
    EXPECT_EQ(document.session().positions, session.positions) << rows;
    document.undoStack().redo();
    EXPECT_EQ(document.session().positions.size(), 1u) << rows;
  }
}

TEST(RemovePosition, ListsEverySightingOfItsZeroInTheJournal) {
  Session session = paperSession();
  PointingZero& zero = session.positions[1].zero;
  zero.faceTwo.horizontal = "152 32 51";
  zero.after.vertical = "89 59 57";
  zero.afterInTwo.horizontal = "152 32 52";
  SessionDocument document;
  document.startWithRecorded(session);
  removePosition(document, 1);
  std::vector<std::string> gone;
  for (const JournalEntry& entry : document.session().journal)
    if (entry.place.starts_with("positions[1].pointing_zero.")) gone.push_back(entry.from);
  EXPECT_THAT(gone, testing::ElementsAre(zero.horizontal, zero.vertical, zero.faceTwo.horizontal,
                                         zero.after.vertical, zero.afterInTwo.horizontal));
}

/// The menu entry that deletes the position in front.
QAction* deletion(OpenWindow& open) {
  for (QAction* top : open->menuBar()->actions())
    for (QAction* action : top->menu()->actions()) {
      emit top->menu()->aboutToShow();
      if (action->text().startsWith(QStringLiteral("Delete Position"))) return action;
    }
  return nullptr;
}

TEST(RemovePosition, AsksBeforeTypedSightingsAreLost) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  open->hideStart();
  open->findChild<PositionTabs*>()->setCurrentIndex(1);
  ASSERT_TRUE(deletion(open));
  open.dialogs->deletePosition = false;
  deletion(open)->trigger();
  EXPECT_EQ(open.dialogs->deletionsAsked, QStringList(QStringLiteral("180°: 18"))) << "17 rows and the zero";
  EXPECT_EQ(open->document().session().positions.size(), 2u);
  open.dialogs->deletePosition = true;
  deletion(open)->trigger();
  EXPECT_EQ(open->document().session().positions.size(), 1u);
  open->document().undoStack().undo();
  EXPECT_EQ(open->document().session().positions, paperSession().positions);
}

TEST(RemovePosition, AsksNothingOfAnEmptyPosition) {
  OpenWindow open;
  open->document().startNew();
  open->hideStart();
  ReadingsEditor(open->document(), 0).insertBlank(0);
  ASSERT_TRUE(deletion(open));
  deletion(open)->trigger();
  EXPECT_TRUE(open.dialogs->deletionsAsked.isEmpty());
  EXPECT_EQ(open->document().session().positions.size(), 1u);
}

TEST(RemovePosition, CountsWhatIsTyped) {
  Position position;
  position.readings.resize(3);
  position.readings[0].point = "1";
  EXPECT_EQ(typedSightings(position), 0u) << "a row laid out, but not read";
  position.readings[1].slider = "10";
  position.readings[2].vertical = "88°";
  position.zero.horizontal = "0";
  position.zero.after.vertical = "90";
  EXPECT_EQ(typedSightings(position), 4u);
}

}  // namespace
}  // namespace alidade::ui
