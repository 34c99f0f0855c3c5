#include <gtest/gtest.h>

#include <QAction>
#include <random>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/models/readings_model.h"

namespace alidade::ui {
namespace {

constexpr ReadingColumn textColumns[] = {
    ReadingColumn::Point,    ReadingColumn::Round,  ReadingColumn::Face, ReadingColumn::Horizontal,
    ReadingColumn::Vertical, ReadingColumn::Slider, ReadingColumn::Note};

/// Makes one edit of any kind, at random.
class RandomEdits {
 public:
  RandomEdits(SessionDocument& document, unsigned seed) : m_document(document), m_random(seed) {}

  void make() {
    ReadingsEditor editor(m_document, pick(2));
    const std::size_t rows = m_document.session().positions[0].readings.size() + 1;
    switch (pick(7)) {
      case 0:
        return editor.setCell({pick(rows), textColumns[pick(std::size(textColumns))]}, text());
      case 1:
        return editor.insertBlank(pick(rows));
      case 2:
        return editor.remove({pick(rows), pick(rows)});
      case 3:
        return editor.setExcluded({pick(rows), pick(rows)}, pick(2) == 0);
      case 4:
        return editor.clear({{pick(rows), ReadingColumn::Vertical}, {pick(rows), ReadingColumn::Note}});
      case 5:
        editor.paste(block(), pick(rows), {ReadingColumn::Horizontal, ReadingColumn::Vertical});
        return;
      default:
        return changeField(m_document, field(), text());
    }
  }

 private:
  std::size_t pick(std::size_t count) { return m_random() % count; }
  std::string text() {
    return pick(5) == 0 ? "" : std::to_string(pick(360)) + " 00 " + std::to_string(pick(60));
  }
  Place field() {
    if (pick(2) == 0) return {.position = pick(2), .field = "pointing_zero.vertical"};
    const char* names[] = {"title", "geometry.distance_mm", "acceptance.tolerance_mm", "instrument.serial"};
    return {.field = names[pick(4)]};
  }
  ReadingBlock block() {
    ReadingBlock cells;
    for (std::size_t i = pick(6); i > 0; --i)
      cells.append({QString::fromStdString(text()), QStringLiteral("x")});
    return cells;
  }

  SessionDocument& m_document;
  std::mt19937 m_random;
};

TEST(Undo, BringsAnySequenceOfEditsBackAndForth) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SessionDocument document;
    ASSERT_FALSE(document.load(samplePath(QStringLiteral("paper-table-1.alidade"))));
    const Session start = document.session();
    const std::string startText = writeSession(start);
    ReadingsModel model(document, 0);
    int rowsReported = model.rowCount();
    QObject::connect(&model, &ReadingsModel::rowsInserted,
                     [&](const QModelIndex&, int first, int last) { rowsReported += last - first + 1; });
    QObject::connect(&model, &ReadingsModel::rowsRemoved,
                     [&](const QModelIndex&, int first, int last) { rowsReported -= last - first + 1; });
    RandomEdits edits(document, seed);
    for (int i = 0; i < 30; ++i) edits.make();
    const Session end = document.session();
    const int steps = document.undoStack().count();
    document.undoStack().setIndex(0);
    EXPECT_EQ(document.session(), start) << "seed " << seed;
    EXPECT_EQ(writeSession(document.session()), startText) << "seed " << seed;
    document.undoStack().setIndex(steps);
    EXPECT_EQ(document.session(), end) << "seed " << seed;
    EXPECT_EQ(model.readingCount(), static_cast<int>(end.positions[0].readings.size()));
    EXPECT_EQ(model.rowCount(), rowsReported);
  }
}

TEST(Undo, NamesWhatItTakesBack) {
  SessionDocument document;
  ASSERT_FALSE(document.load(samplePath(QStringLiteral("paper-table-1.alidade"))));
  ReadingsEditor editor(document, 0);
  const QUndoStack& stack = document.undoStack();
  editor.setCell({4, ReadingColumn::Vertical}, "82 40 40");
  EXPECT_EQ(stack.undoText(), QStringLiteral("Change vertical reading of point 5"));
  editor.setExcluded({4}, true);
  EXPECT_EQ(stack.undoText(), QStringLiteral("Exclude reading"));
  editor.remove({1, 2, 3});
  EXPECT_EQ(stack.undoText(), QStringLiteral("Delete 3 readings"));
  changeField(document, {.position = 1, .field = "pointing_zero.vertical"}, "90 00 00");
  EXPECT_EQ(stack.undoText(), QStringLiteral("Change pointing zero β0"));
}

TEST(Undo, LeavesNoStepForAnEditThatChangesNothing) {
  SessionDocument document;
  ASSERT_FALSE(document.load(samplePath(QStringLiteral("paper-table-1.alidade"))));
  const Session& session = document.session();
  ReadingsEditor editor(document, 0);
  editor.setCell({0, ReadingColumn::Horizontal}, session.positions[0].readings[0].horizontal);
  editor.setExcluded({0}, false);
  editor.remove({900});
  editor.setCell({17, ReadingColumn::Horizontal}, "");
  changeField(document, {.field = "title"}, session.title);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(Undo, IsOfferedWhereThereIsSomethingToTakeBack) {
  OpenWindow open;
  const auto isOffered = [&](const char* action) {
    for (const QAction* found : open->findChildren<QAction*>())
      if (found->text().startsWith(QString::fromLatin1(action))) return found->isEnabled();
    ADD_FAILURE() << action;
    return false;
  };
  EXPECT_FALSE(isOffered("&Undo"));
  EXPECT_FALSE(isOffered("&Redo"));
  changeField(open->document(), {.field = "title"}, "one");
  EXPECT_TRUE(isOffered("&Undo"));
  EXPECT_FALSE(isOffered("&Redo"));
  open->undo();
  EXPECT_FALSE(isOffered("&Undo"));
  EXPECT_TRUE(isOffered("&Redo"));
}

}  // namespace
}  // namespace alidade::ui
