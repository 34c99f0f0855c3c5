#include "core/exchange/csv_reader.h"

#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(CsvReader, ReadsEveryColumn) {
  const Recording recording = readTable(
      "axis_deg;Point No;round;Face;Horizontal circle;V angle;slider;remark;excluded\n"
      "180°;4;2;II;341°52'24\";88,16°;10 00 00;wind;yes\n",
      {});
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 1u);
  const RecordedSighting& sighting = recording.sightings[0];
  EXPECT_EQ(sighting.line, 2u);
  EXPECT_EQ(sighting.axis.text, "180");
  EXPECT_EQ(sighting.row.point, "4");
  EXPECT_EQ(sighting.row.round, "2");
  EXPECT_EQ(sighting.row.face, "2");
  EXPECT_EQ(sighting.row.horizontal, "341°52'24\"");
  EXPECT_EQ(sighting.columnOf(rowField(&Reading::horizontal)), 13u);
  EXPECT_EQ(sighting.row.vertical, "88,16°");
  EXPECT_EQ(sighting.row.slider, "10 00 00");
  EXPECT_EQ(sighting.row.note, "wind");
  EXPECT_TRUE(sighting.row.excluded);
}

TEST(CsvReader, KnowsOtherNamesOfTheColumns) {
  for (const char* names : {"Hz,V", "H,V", "α,β", "alpha;beta", "Direction\tZenith", "hz_reading,va",
                            "HORIZONTAL ANGLE,VERTICAL ANGLE", "Hz [gon],V [gon]", "Elevation,Hz"}) {
    const Recording recording = readTable(std::string(names) + "\n", {});
    EXPECT_THAT(recording.problems, IsEmpty()) << names;
  }
  EXPECT_EQ(readTable("Elevation,Hz\n", {}).verticalCircle, "elevation");
  EXPECT_EQ(readTable("Hz,V\n", {}).verticalCircle, "");
}

TEST(CsvReader, TakesTheUnitFromTheNameFirst) {
  const auto first = [](const std::string& text, AngleUnit unit) {
    return readTable(text, {.unit = unit}).sightings.at(0).row.horizontal;
  };
  EXPECT_EQ(first("Hz [gon];V\n379,859;1", AngleUnit::Degrees), "379,859gon");
  EXPECT_EQ(first("hz_deg,v_deg\n341.5,1", AngleUnit::Unstated), "341.5°");
  EXPECT_EQ(first("Hz (DMS),V\n341.5224,1", AngleUnit::Unstated), "341 52 24");
  EXPECT_EQ(first("Hz,V\n341.5,1", AngleUnit::Gon), "341.5gon");
  EXPECT_EQ(first("Hz,V\n341.5,1", AngleUnit::Unstated), "341.5");
}

TEST(CsvReader, KnowsThePointingZero) {
  EXPECT_TRUE(readTable("point,Hz,V\nZero,1°,2°", {}).sightings.at(0).isZero);
  EXPECT_FALSE(readTable("point,Hz,V\n0,1°,2°", {}).sightings.at(0).isZero) << "points may count from 0";
  EXPECT_TRUE(readTable("point,Hz,V\nRef,1°,2°", {}, "REF").sightings.at(0).isZero);
}

TEST(CsvReader, ListsColumnsItDoesNotUse) {
  const Recording recording = readTable("Hz,V,temperature,distance\n1°,2°,20.5,\n1°,2°,20.5,3\n", {});
  EXPECT_THAT(recording.unused, testing::ElementsAre("the column “temperature” is not used: 2 values"));
  EXPECT_THAT(recording.unusedBySession, testing::ElementsAre("the column “distance” is not used: 1 value"));
  EXPECT_EQ(recording.sightings[1].distanceM, 3);
}

// DOS programs end a text by ^Z, in the last cell or in a line of its own; old bytes may follow the sign.
TEST(CsvReader, EndsAtTheSignOfDos) {
  const std::string head = "point,horizontal,vertical\n1,10 00 00,90 00 00", more = "2,11 00 00,91 00 00\n";
  for (const auto& [end, line] : {std::pair("\x1A\n", "line 2"), std::pair("\n\x1A", "line 3")}) {
    const Recording recording = readTable(head + end + more, {});
    EXPECT_THAT(recording.problems, IsEmpty());
    ASSERT_EQ(recording.sightings.size(), 1u);
    EXPECT_EQ(recording.sightings[0].row.vertical, "90 00 00");
    EXPECT_THAT(
        recording.unused,
        testing::ElementsAre(std::string("content after the end of the file (^Z) is not used: ") + line));
  }
}

TEST(CsvReader, NamesWhatIsWrong) {
  const auto problem = [](const std::string& text) {
    const Recording recording = readTable(text, {});
    return recording.problems.empty() ? std::string() : recording.problems.front().text();
  };
  EXPECT_THAT(problem("1,2,3\n4,5,6"), HasSubstr("line 1: no column is named “horizontal”"));
  EXPECT_THAT(problem("Hz,point\n"), HasSubstr("“vertical”"));
  EXPECT_THAT(problem("Hz,V,hz\n"), HasSubstr("line 1, column 6: “hz” is a second column"));
  EXPECT_THAT(problem("Hz,V\n379,85,93,12\n"), HasSubstr("line 2, column 8: “93” is beyond"));
  EXPECT_THAT(problem("Hz,V,skip\n1°,2°,perhaps\n"), HasSubstr("neither yes nor no"));
  EXPECT_THAT(problem("Hz,V\n\"1°,2°\n"), HasSubstr("line 2, column 1"));
}

}  // namespace
}  // namespace alidade::test
