#include "ui/commands/change_positions.h"

#include <gtest/gtest.h>

#include "tests/ui/support.h"
#include "ui/document/session_document.h"

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

}  // namespace
}  // namespace alidade::ui
