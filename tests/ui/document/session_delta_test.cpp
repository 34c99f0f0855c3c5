#include "ui/document/session_delta.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/session/session_file.h"
#include "tests/support/large_session.h"
#include "tests/ui/support.h"
#include "ui/commands/change_effects.h"
#include "ui/commands/change_field.h"
#include "ui/commands/change_known.h"
#include "ui/commands/change_positions.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"
#include "ui/jobs/fit_request.h"

namespace alidade::ui {
namespace {

/// A copy that follows a document by its change signals alone.
struct Mirror {
  explicit Mirror(SessionDocument& document) : session(document.session()) {
    QObject::connect(&document, &SessionDocument::changed, &context,
                     [this, &document](const SessionChange& change) {
                       const SessionDelta delta(document.session(), change);
                       held = delta.size();
                       delta.applyTo(session);
                     });
  }

  Session session;
  std::size_t held = 0;
  QObject context;
};

TEST(SessionDelta, LeavesACopyAsTheDocumentIs) {
  SessionDocument document;
  document.startWith(paperSession());
  Mirror mirror(document);
  std::mt19937 random(4);
  const auto expectSame = [&](const char* after) {
    EXPECT_EQ(mirror.session, document.session()) << after;
    EXPECT_EQ(writeSession(mirror.session), writeSession(document.session())) << after;
  };
  ReadingsEditor upper(document, 0), lower(document, 1);
  upper.setCell({3, ReadingColumn::Vertical}, "82 00 00");
  expectSame("a cell");
  lower.remove({2, 5, 6});
  expectSame("rows that went");
  upper.insertBlank(4);
  expectSame("a row that came");
  upper.paste(parseBlock(QStringLiteral("1\t2\n3\t4\n5\t6")), 16,
              {ReadingColumn::Horizontal, ReadingColumn::Vertical});
  expectSame("a block over the end");
  changeField(document, {.field = "title"}, "other");
  changeField(document, {.position = 1, .field = "pointing_zero.vertical"}, "91 00 00");
  expectSame("fields");
  setEffect(document, "collimation", true);
  expectSame("effects");
  keepOwnEffect(document, {.id = "dip", .name = "Dip", .formula = "a * cos(V)"});
  expectSame("an effect of one's own");
  const auto collimation = [&] {
    const std::vector<KnownRow> rows = knownRows(document.session());
    return *std::ranges::find_if(rows, [](const KnownRow& row) { return row.effect->id == "collimation"; });
  };
  for (const char* text : {"1", ""}) {
    typeKnown(document, collimation(), knownCells[1], text);
    expectSame("a known size");
  }
  for (int step = 0; step < 60; ++step) {
    document.undoStack().setIndex(
        static_cast<int>(random() % static_cast<unsigned>(document.undoStack().count() + 1)));
    expectSame("undo and redo");
  }
  document.startWith(Session{});
  addPosition(document, 180);
  expectSame("another session with a position");
}

TEST(SessionDelta, HoldsNoMoreThanWasEdited) {
  SessionDocument document;
  document.startWith(test::largeSession(10000));
  Mirror mirror(document);
  ReadingsEditor editor(document, 0);
  editor.setCell({4000, ReadingColumn::Vertical}, "82 00 00");
  EXPECT_EQ(mirror.held, 1u);
  editor.remove({4000});
  EXPECT_EQ(mirror.held, 1u);
  document.undoStack().undo();
  EXPECT_EQ(mirror.held, 1u);
  EXPECT_EQ(mirror.session, document.session());
  document.startWith(paperSession());
  EXPECT_EQ(mirror.held, 34u) << "17 rows of each position of another session";
}

TEST(FitRequest, CopiesTheWholeSessionOnlyWhereThatIsLess) {
  SessionDocument document;
  document.startWith(paperSession());
  const Session before = document.session();
  std::optional<FitRequest> request;
  QObject context;
  int wholes = 0;
  QObject::connect(&document, &SessionDocument::changed, &context, [&](const SessionChange& change) {
    request ? request->add(document.session(), change) : void(request.emplace(document.session(), change));
    if (request->isWhole()) ++wholes;
  });
  ReadingsEditor editor(document, 0);
  for (int i = 0; i < 900; ++i) editor.setCell({3, ReadingColumn::Note}, std::to_string(i));
  EXPECT_EQ(wholes, 0);
  EXPECT_EQ(request->onto(before), document.session());
  for (int i = 0; i < 900; ++i) editor.setCell({4, ReadingColumn::Note}, std::to_string(i));
  EXPECT_TRUE(request->isWhole());
  EXPECT_EQ(request->onto({}), document.session());
}

}  // namespace
}  // namespace alidade::ui
