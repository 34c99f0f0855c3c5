#include <gmock/gmock.h>

#include <QApplication>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>

#include "tests/support/large_session.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/connection/instrument_desk.h"
#include "ui/forms/field_edit.h"
#include "ui/instrument/check_rows_table.h"
#include "ui/main_window.h"
#include "ui/panels/model/known_sizes_table.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/text/entry_text.h"

// Events during typing: fits, diagnoses, readings of an instrument, other changes of the session. None of
// these changes an open editor or an unfinished form. Here they arrive between any two keys.

namespace alidade::ui {
namespace {

class Typing : public ::testing::Test {
 protected:
  Typing() { QApplication::setActiveWindow(open.window.get()); }

  void start(const Session& session) {
    open->document().startWith(session);
    open.waitUntilIdle();
    QCoreApplication::processEvents();
  }

  /// Evaluates the current session, and waits until all views show the result.
  void news() {
    open->job().request(open->document().session());
    open.waitUntilIdle();
  }

  /// Types by keyboard into the focused widget, with an event after every `every`-th key.
  void type(const std::string& text, int every, Qt::Key end = Qt::Key_Return) {
    for (const QChar key : qText(text)) {
      QTest::keyClick(QApplication::focusWidget(), key.toLatin1());
      if (++keys % every == 0) news();
    }
    if (end != Qt::Key_unknown) QTest::keyClick(QApplication::focusWidget(), end);
  }

  const Session& session() { return open->document().session(); }
  QLineEdit* editor() { return qobject_cast<QLineEdit*>(QApplication::focusWidget()); }

  OpenWindow open;
  int keys = 0;
};

/// An angle as typed at the bench: digits and blanks, without signs.
std::string plain(std::string angle) {
  for (const std::string sign : {"°", "'", "\"", "′", "″"})
    for (std::size_t at = angle.find(sign); at != std::string::npos; at = angle.find(sign))
      angle.replace(at, sign.size(), " ");
  while (!angle.empty() && angle.back() == ' ') angle.pop_back();
  return angle;
}

TEST_F(Typing, AWholeTableArrivesAsTypedWhileFitsDo) {
  const Session published = paperSession();
  Session empty = published;
  for (Position& position : empty.positions) position.readings.clear();
  start(empty);
  for (const std::size_t position : {0u, 1u}) {
    open->reveal({.position = position, .reading = 0, .field = "horizontal"});
    for (const Reading& row : published.positions[position].readings) {
      type(plain(row.horizontal), 7);  // not a divisor of the number of keys of an angle, so each key is once
                                       // the last before an event
      type(plain(row.vertical), 7);
    }
  }
  for (const std::size_t position : {0u, 1u}) {
    const auto &typed = session().positions[position].readings,
               &read = published.positions[position].readings;
    ASSERT_EQ(typed.size(), read.size());
    for (std::size_t row = 0; row < read.size(); ++row) {
      EXPECT_EQ(typed[row].horizontal, plain(read[row].horizontal)) << position << ' ' << row;
      EXPECT_EQ(typed[row].vertical, plain(read[row].vertical)) << position << ' ' << row;
    }
  }
}

/// The test types into new rows and over old texts, in sessions with slower and slower evaluation.
TEST_F(Typing, NewsBetweenAnyTwoKeysTakesNoneAway) {
  for (const std::size_t size : {34u, 1000u, 20000u}) {
    start(test::largeSession(size));
    const std::size_t end = session().positions[0].readings.size();
    for (const std::size_t row : {end, end / 2}) {
      open->reveal({.position = 0, .reading = row, .field = "horizontal"});
      type("323 11 43", 1);
      type("87 9 8.25", 1);
      EXPECT_EQ(session().positions[0].readings[row].horizontal, "323 11 43") << size << ' ' << row;
      EXPECT_EQ(session().positions[0].readings[row].vertical, "87 9 8.25") << size << ' ' << row;
    }
  }
}

TEST_F(Typing, TheCursorInAnEntryStaysWhereItIs) {
  start(paperSession());
  ReadingsTable& table = *open->currentTable();
  open->reveal({.position = 0, .reading = 3, .field = "horizontal"});
  QTest::keyClick(&table, Qt::Key_F2);
  ASSERT_TRUE(editor());
  editor()->setCursorPosition(2);
  news();
  ASSERT_TRUE(editor());
  EXPECT_EQ(editor()->cursorPosition(), 2);
}

TEST_F(Typing, KnownSizesKeepWhatIsHalfTyped) {
  start(paperSession());
  typeKnown(open->document(), knownRows(session()).at(0), knownCells[0], "3");
  auto& table = *open->findChild<KnownSizesTable*>();
  open->reveal({.field = "instrument.known[0].value"});
  table.setFocus();
  table.reveal(table.model()->index(4, table.currentIndex().column()));
  type("12.5", 1, Qt::Key_unknown);
  typeKnown(open->document(), knownRows(session()).at(0), knownCells[0], "4");
  news();
  ASSERT_TRUE(editor());
  EXPECT_EQ(editor()->text(), QStringLiteral("12.5"));
  QTest::keyClick(editor(), Qt::Key_Return);
  EXPECT_EQ(table.model()->index(4, 3).data(Qt::EditRole).toString(), QStringLiteral("12.5"));
}

TEST_F(Typing, TheRowsOfACheckKeepWhatIsHalfTyped) {
  CheckRowsTable table;
  table.show();
  QApplication::setActiveWindow(&table);
  table.setFocus();
  table.setCurrentIndex(table.model()->index(0, 4));
  for (const char key : std::string("323 11")) QTest::keyClick(QApplication::focusWidget(), key);
  emit table.model()->dataChanged(table.model()->index(0, 0), table.model()->index(0, 6));
  ASSERT_TRUE(editor());
  EXPECT_EQ(editor()->text(), QStringLiteral("323 11"));
}

TEST_F(Typing, FormsKeepWhatIsHalfTyped) {
  start(paperSession());
  open->reveal({.field = "geometry.distance_mm"});
  type("2406.5", 1, Qt::Key_unknown);
  changeField(open->document(), {.field = "geometry.distance_mm"}, "1");
  news();
  EXPECT_EQ(editor()->text(), QStringLiteral("2406.5"));
  open->reveal({.field = "notes"});
  auto* notes = qobject_cast<QPlainTextEdit*>(QApplication::focusWidget());
  ASSERT_TRUE(notes);
  EXPECT_EQ(session().geometry.distanceMm, "2406.5") << "handed in when the focus left";
  notes->selectAll();
  type("windy, twice", 1, Qt::Key_unknown);
  changeField(open->document(), {.field = "notes"}, "other");
  news();
  EXPECT_EQ(notes->toPlainText(), QStringLiteral("windy, twice"));
}

/// The reading does not commit an unfinished angle or move the focus.
TEST_F(Typing, AReadingOfTheInstrumentWaitsForTheOpenEntry) {
  Session session = paperSession();
  session.positions[0].readings.resize(5);
  start(session);
  open->reveal({.position = 0, .reading = 2, .field = "horizontal"});
  type("323 11", 1, Qt::Key_unknown);
  QLineEdit* typed = editor();
  ReadingFlow& flow = open->instrumentDesk().flow();
  InstrumentReading reading;
  reading.horizontal = "350°00'00\"";
  reading.vertical = "88°00'00\"";
  flow.add(reading);
  news();
  QCoreApplication::processEvents();
  EXPECT_TRUE(flow.isHeldByEntry());
  EXPECT_EQ(flow.waiting(), 1u);
  ASSERT_EQ(editor(), typed);
  EXPECT_EQ(typed->text(), QStringLiteral("323 11"));
  EXPECT_EQ(this->session().positions[0].readings.size(), 5u);
  for (const char key : std::string(" 43")) QTest::keyClick(typed, key);
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_TRUE(waitFor([&] { return !flow.question().isEmpty() || flow.waiting() == 0; }));
  EXPECT_FALSE(flow.isHeldByEntry());
  EXPECT_EQ(this->session().positions[0].readings[2].horizontal, "323 11 43");
}

TEST_F(Typing, TheTitleMarksWhatIsHalfTyped) {
  start(paperSession());
  ASSERT_FALSE(open->isWindowModified()) << "as it was started";
  open->reveal({.field = "operator"});
  type("A", 1, Qt::Key_unknown);
  EXPECT_TRUE(open->isWindowModified());
  QTest::keyClick(editor(), Qt::Key_Escape);
  EXPECT_FALSE(open->isWindowModified());
  open->reveal({.position = 0, .reading = 0, .field = "vertical"});
  type("8", 1, Qt::Key_unknown);
  EXPECT_TRUE(open->isWindowModified());
  QTest::keyClick(editor(), Qt::Key_Escape);
  EXPECT_FALSE(open->isWindowModified());
}

}  // namespace
}  // namespace alidade::ui
