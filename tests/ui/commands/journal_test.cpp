#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>

#include "core/session/journal.h"
#include "tests/ui/support.h"
#include "ui/commands/change_positions.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/session_commands.h"
#include "ui/document/session_document.h"

namespace alidade::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A session with its journal as texts: "from > to, why".
struct Bench {
  SessionDocument document;
  QTemporaryDir folder;

  explicit Bench(bool isFiled = true) {
    document.startWith(paperSession());
    if (isFiled) save();
  }

  void save() { EXPECT_FALSE(document.save(folder.filePath(QStringLiteral("s.alidade")))); }
  ReadingsEditor editor(std::size_t position = 0) { return {document, position}; }
  void type(std::size_t row, const std::string& text, ReadingColumn column = ReadingColumn::Horizontal) {
    editor().setCell({row, column}, text);
  }
  void undo() { document.undoStack().undo(); }
  void redo() { document.undoStack().redo(); }
  const Reading& row(std::size_t row) { return document.session().positions[0].readings[row]; }

  std::vector<std::string> journal() {
    std::vector<std::string> texts;
    for (const JournalEntry& entry : document.session().journal)
      texts.push_back(entry.from + " > " + entry.to + ", " + entry.why);
    EXPECT_FALSE(firstBrokenEntry(document.session().journal));
    return texts;
  }
};

TEST(JournalOfEdits, KeepsTheFirstTextOfAReadingThatStood) {
  Bench bench;
  const std::string first = bench.row(3).horizontal;
  bench.type(3, "340 00 00");
  bench.type(3, "340 00 01");
  EXPECT_EQ(bench.row(3).asRead.of("horizontal"), first);
  EXPECT_THAT(bench.journal(),
              ElementsAre(first + " > 340 00 00, retyped", "340 00 00 > 340 00 01, retyped"));
  const JournalEntry& entry = bench.document.session().journal[0];
  EXPECT_EQ(entry.place, "positions[0].readings[3].horizontal");
  EXPECT_EQ(entry.axis, "0");
  EXPECT_EQ(entry.point, "4");
  EXPECT_THAT(entry.at, testing::MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}Z"));

  bench.type(3, first);
  EXPECT_TRUE(bench.row(3).asRead.empty()) << "it is as it was read";
  EXPECT_EQ(bench.journal().size(), 3U) << "the way there is not forgotten";
}

TEST(JournalOfEdits, PassesOverWhatIsStillBeingTyped) {
  Bench bench;
  const std::size_t end = bench.document.session().positions[0].readings.size();
  bench.type(end, "300 00 00");
  bench.type(end, "80 00 00", ReadingColumn::Vertical);
  bench.type(end, "300 00 01");
  bench.type(end, "80 00 01", ReadingColumn::Vertical);
  EXPECT_THAT(bench.journal(), IsEmpty()) << "the row is the last thing typed";
  bench.type(end + 1, "299 00 00");
  bench.type(end, "300 00 02");
  EXPECT_THAT(bench.journal(), ElementsAre("300 00 01 > 300 00 02, retyped")) << "another was read meanwhile";
  bench.type(end + 1, "80 00 00", ReadingColumn::Vertical);
  bench.type(end + 1, "299 00 01");
  EXPECT_EQ(bench.journal().size(), 2U) << "and its direction stands since the row was left";
}

TEST(JournalOfEdits, CountsAReadingAsMadeOnceItIsSaved) {
  Bench bench;
  const std::size_t end = bench.document.session().positions[0].readings.size();
  bench.type(end, "300 00 00");
  bench.save();
  bench.type(end, "300 00 01");
  EXPECT_THAT(bench.journal(), ElementsAre("300 00 00 > 300 00 01, retyped"));
}

TEST(JournalOfEdits, FillingInACellThatWasLeftEmptyIsNoChange) {
  Bench bench;
  bench.type(2, "12.5", ReadingColumn::Slider);
  EXPECT_THAT(bench.journal(), IsEmpty());
  bench.type(5, "30.5", ReadingColumn::Slider);
  bench.type(2, "12.6", ReadingColumn::Slider);
  EXPECT_THAT(bench.journal(), ElementsAre("12.5 > 12.6, retyped"));
}

TEST(JournalOfEdits, UndoneBeforeItWasSavedLeavesNoTrace) {
  Bench bench;
  const Session before = bench.document.session();
  bench.type(3, "340 00 00");
  bench.editor().remove({5, 6});
  bench.editor().setExcluded({1}, true);
  EXPECT_EQ(bench.journal().size(), 4U);
  for (int i = 0; i < 3; ++i) bench.undo();
  EXPECT_EQ(bench.document.session(), before);
  EXPECT_FALSE(bench.document.isModified());
  for (int i = 0; i < 3; ++i) bench.redo();
  EXPECT_EQ(bench.journal().size(), 4U);
}

TEST(JournalOfEdits, RedoneInALaterSecondIsWhatItWas) {
  Bench bench;
  bench.type(3, "340 00 00");
  const Session changed = bench.document.session();
  bench.undo();
  QTest::qWait(1100);
  bench.redo();
  EXPECT_EQ(bench.document.session(), changed);
}

TEST(JournalOfEdits, UndoneAfterItWasSavedIsTold) {
  Bench bench;
  const std::string first = bench.row(3).horizontal;
  bench.type(3, "340 00 00");
  bench.save();
  const Session saved = bench.document.session();
  bench.undo();
  EXPECT_THAT(bench.journal(),
              ElementsAre(first + " > 340 00 00, retyped", "340 00 00 > " + first + ", undone"));
  EXPECT_TRUE(bench.row(3).asRead.empty());
  EXPECT_TRUE(bench.document.isModified());
  bench.redo();
  EXPECT_EQ(bench.document.session(), saved) << "as in the file, journal and all";
  EXPECT_FALSE(bench.document.isModified());
}

TEST(JournalOfEdits, TellsOfEachWayToChangeReadings) {
  Bench bench;
  const Reading second = bench.row(1);
  bench.editor().setExcluded({1}, true);
  bench.editor().setExcluded({1}, false);
  applyChanges(bench.document,
               {{.where = {.position = 0, .reading = 1, .field = "vertical"}, .text = "80 00 00"}},
               QStringLiteral("Use proposal"));
  bench.editor().clear({{1, ReadingColumn::Vertical}});
  bench.editor().paste({{QStringLiteral("1°")}}, 1, {ReadingColumn::Horizontal});
  bench.editor().remove({1});
  EXPECT_THAT(bench.journal(), ElementsAre("used > excluded, excluded", "excluded > used, used_again",
                                           second.vertical + " > 80 00 00, suggestion",
                                           "80 00 00 > , cleared", second.horizontal + " > 1°, pasted",
                                           "point 2, round 1, face 1, horizontal 1° > , deleted"));
}

TEST(JournalOfEdits, TellsOfARowThatGoesWhicheverOfItsCellsWasRead) {
  Bench bench;
  const std::size_t end = bench.document.session().positions[0].readings.size();
  bench.type(end, "80 00 00", ReadingColumn::Vertical);
  bench.editor().remove({end});
  EXPECT_THAT(bench.journal(), IsEmpty()) << "still being typed";
  bench.type(end, "80 00 00", ReadingColumn::Vertical);
  bench.save();
  bench.editor().remove({end});
  ASSERT_EQ(bench.journal().size(), 1U);
  EXPECT_THAT(bench.journal()[0], testing::HasSubstr("vertical 80 00 00 > , deleted"));
}

TEST(JournalOfEdits, OfAThousandRowsSaysHowManyAndEachKeepsItsFirstText) {
  Bench bench;
  ReadingBlock block;
  for (int i = 0; i < 1500; ++i) block.append({QString::number(i % 300), QStringLiteral("80")});
  bench.editor().paste(block, 0, {ReadingColumn::Horizontal, ReadingColumn::Vertical});
  bench.save();
  bench.editor().paste(block, 1, {ReadingColumn::Vertical, ReadingColumn::Horizontal});
  EXPECT_EQ(bench.journal().size(), 34U + 1) << "17 rows of the paper's, then all at once";
  EXPECT_EQ(bench.row(700).asRead.of("horizontal"), "100");
}

TEST(JournalOfEdits, TellsOfAThousandCellsEachAndOfMoreTogether) {
  for (const int cells : {1000, 1001}) {
    Bench bench;
    ReadingBlock block;
    for (int i = 0; i < cells; ++i) block.append({QString::number(i % 300)});
    bench.editor().paste(block, 17, {ReadingColumn::Horizontal});
    bench.save();
    std::vector<ReadingCell> cleared;
    for (int i = 0; i < cells; ++i) cleared.push_back({17 + static_cast<std::size_t>(i)});
    bench.editor().clear(cleared);
    const std::vector<std::string> journal = bench.journal();
    EXPECT_EQ(journal.size(), cells == 1000 ? 1000U : 1U);
    EXPECT_EQ(journal.back(), cells == 1000 ? "99 > , cleared" : "1001 entries > 1001 entries, cleared");
  }
}

TEST(JournalOfEdits, TellsOfZerosAndLengths) {
  Bench bench;
  const Place zero{.position = 1, .field = "pointing_zero.vertical"}, length{.field = "geometry.distance_mm"};
  changeField(bench.document, zero, "90 00 03");
  changeField(bench.document, length, "2406");
  changeField(bench.document, {.field = "title"}, "Another");
  changeField(bench.document, {.field = "geometry.sigma_radius_mm"}, "0.1");
  changeField(bench.document, {.field = "geometry.sigma_radius_mm"}, "0.2");
  setEffect(bench.document, "trunnion_tilt", true);
  EXPECT_EQ(bench.journal().size(), 2U) << "a title is said about the session, the others were empty";
  EXPECT_EQ(bench.document.session().journal[0].axis, "180");
  EXPECT_EQ(bench.document.session().journal[1].to, "2406");
}

TEST(JournalOfEdits, ANewSessionMayBeFilledInAtLeisureButAZeroStandsOnceReadingsFollow) {
  Bench bench(false);
  changeField(bench.document, {.field = "geometry.distance_mm"}, "2406");
  changeField(bench.document, {.field = "geometry.distance_mm"}, "2407");
  EXPECT_THAT(bench.journal(), IsEmpty());
  const Place zero{.position = 0, .field = "pointing_zero.horizontal"};
  SessionDocument& document = bench.document;
  document.startNew();
  changeField(document, zero, "332 32 54");
  changeField(document, zero, "332 32 55");
  EXPECT_THAT(bench.journal(), IsEmpty()) << "still being typed";
  bench.type(0, "341 52 24");
  changeField(document, zero, "332 32 56");
  EXPECT_THAT(bench.journal(), ElementsAre("332 32 55 > 332 32 56, retyped"));
}

TEST(JournalOfEdits, AfterASealTellsOfEveryEdit) {
  Bench bench;
  auto seal = [&] { return sealOf(bench.document.session().journal); };
  bench.document.push(new SealSession(bench.document, "R. Roe"));
  bench.save();
  ASSERT_TRUE(seal());
  EXPECT_TRUE(isAsSealed(bench.document.session(), *seal()));
  changeField(bench.document, {.field = "title"}, "Another");
  const std::size_t end = bench.document.session().positions[0].readings.size();
  bench.type(end, "300 00 00");
  bench.type(end, "80 00 00", ReadingColumn::Vertical);
  addPosition(bench.document, 0);
  bench.type(2, "12.5", ReadingColumn::Slider);
  EXPECT_EQ(bench.journal().size(), 6U);
  EXPECT_TRUE(bench.row(2).asRead.empty()) << "nothing had been read there";
  EXPECT_FALSE(isAsSealed(bench.document.session(), *seal()));
  for (int i = 0; i < 5; ++i) bench.undo();
  EXPECT_TRUE(isAsSealed(bench.document.session(), *seal()));
}

}  // namespace
}  // namespace alidade::ui
