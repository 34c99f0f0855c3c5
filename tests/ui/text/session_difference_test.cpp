#include "ui/text/session_difference.h"

#include <gmock/gmock.h>

#include "core/session/session_file.h"
#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// "where: mine | theirs".
std::vector<std::string> linesOf(const Session& mine, const Session& theirs) {
  std::vector<std::string> lines;
  const SessionDifference difference = differenceOf(mine, theirs);
  EXPECT_EQ(difference.count, difference.entries.size());
  for (const EntryDifference& entry : difference.entries)
    lines.push_back((entry.where + QStringLiteral(": ") + entry.mine + QStringLiteral(" | ") + entry.theirs)
                        .toStdString());
  return lines;
}

TEST(SessionDifference, NamesEachEntryThatDiffers) {
  const Session mine = paperSession();
  EXPECT_THAT(linesOf(mine, mine), IsEmpty());
  Session theirs = mine;
  theirs.geometry.distanceMm = "2406";
  theirs.model.effects = {"collimation", "trunnion_tilt"};
  theirs.positions[1].zero.vertical = "89°";
  theirs.positions[1].readings[3].vertical = "x";
  theirs.positions[1].readings[3].excluded = true;
  const auto lines = linesOf(mine, theirs);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "distance L: " + mine.geometry.distanceMm + " | 2406");
  EXPECT_EQ(lines[1], "180°, pointing zero β0: " + mine.positions[1].zero.vertical + " | 89°");
  EXPECT_EQ(lines[2], "model effects:  | collimation, trunnion tilt");
  EXPECT_EQ(lines[3],
            "180°, row 4 (point 4), vertical reading: " + mine.positions[1].readings[3].vertical + " | x");
  EXPECT_EQ(lines[4], "180°, row 4 (point 4), excluded: no | yes");
}

TEST(SessionDifference, NamesWhatIsKnownOtherwise) {
  Session mine = paperSession(), theirs = mine;
  mine.instrument.known = {{.effect = "collimation", .value = "3.2", .sigma = "0.5", .unit = "arcsec"}};
  theirs.instrument.known = {{.effect = "collimation", .sigma = "0.5", .unit = "arcsec", .from = "check"},
                             {.effect = "trunnion_tilt", .sigma = "1", .unit = "arcsec"}};
  EXPECT_THAT(linesOf(mine, theirs),
              ElementsAre("known size of collimation: collimation 3.2 u 0.5 arcsec | collimation u 0.5 "
                          "arcsec, check",
                          "known size of trunnion tilt:  | trunnion tilt u 1 arcsec"));
}

// An inserted row shifts all following rows; only the inserted one is a difference.
TEST(SessionDifference, TellsOfRowsPutInAndTakenOut) {
  const Session mine = paperSession();
  Session more = mine;
  Reading row;
  row.horizontal = "1°";
  row.vertical = "2°";
  more.positions[0].readings.insert(more.positions[0].readings.begin() + 5, row);
  EXPECT_THAT(linesOf(mine, more), ElementsAre("0°, row 6:  | 1°  2°"));
  EXPECT_THAT(linesOf(more, mine), ElementsAre("0°, row 6: 1°  2° | "));
  more.positions[0].readings[5] = Reading();
  EXPECT_THAT(linesOf(mine, more), ElementsAre("0°, row 6:  | a row"));
  Session one = mine;
  one.positions.pop_back();
  EXPECT_THAT(linesOf(mine, one), ElementsAre("180°: 17 rows | "));
  EXPECT_THAT(linesOf(one, mine), ElementsAre("180°:  | 17 rows"));
  Session again = mine;
  again.positions.emplace_back().axisDeg = "0";
  EXPECT_THAT(linesOf(mine, again), ElementsAre("0° again:  | 0 rows"));
}

TEST(SessionDifference, KnowsThatEntriesDifferThatAreNotShown) {
  const std::string text = writeSession(paperSession());
  std::string more = text;
  more.insert(1, "\"weather\": \"fog\",");
  EXPECT_THAT(linesOf(*readSession(text), *readSession(more)),
              ElementsAre("entries that are not shown:  | "));
}

TEST(SessionDifference, CountsMoreThanItLists) {
  Session mine = paperSession(), theirs;
  mine.positions[0].readings.resize(5000);
  theirs = mine;
  for (Reading& reading : theirs.positions[0].readings) reading.note = "n";
  const SessionDifference difference = differenceOf(mine, theirs);
  EXPECT_EQ(difference.count, 5000u);
  EXPECT_EQ(difference.entries.size(), SessionDifference::most);
}

}  // namespace
}  // namespace alidade::ui
