#include "core/exchange/gsi_reader.h"

#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string point = " 21.324+34152240 22.324+08816490";

TEST(GsiReader, ReadsSightingsWithTheirNames) {
  const Recording recording =
      readGsi("110001+00000007" + point + " 71....+0000WIND\r\n*110002+0000000000000A12" +
              " 21.102+0000000017920860 22.102+0000000007567500\r\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_THAT(recording.unused, IsEmpty());
  EXPECT_EQ(recording.format, "GSI-16");
  ASSERT_EQ(recording.sightings.size(), 2u);
  const RecordedSighting& first = recording.sightings[0];
  EXPECT_EQ(first.row.point, "7");
  EXPECT_EQ(first.row.horizontal, "341°52'24.0\"");
  EXPECT_EQ(first.columnOf(rowField(&Reading::horizontal)), 17u);
  EXPECT_EQ(first.row.vertical, "88°16'49.0\"");
  EXPECT_EQ(first.row.note, "WIND");
  EXPECT_EQ(recording.sightings[1].row.point, "A12");
  EXPECT_EQ(recording.sightings[1].line, 2u);
}

TEST(GsiReader, TakesAxisAndRoundFromCodes) {
  const Recording recording = readGsi("110001+00000001" + point + "\n41....+00000180\n110001+00000001" +
                                      point + "\n41....+0ROUND02\n110001+00000001" + point +
                                      "\n41....+0000axis 42....+00000000\n110001+00000001" + point +
                                      "\n41....+000ROUND 42....+00000003\n110001+00000001" + point);
  ASSERT_EQ(recording.sightings.size(), 5u);
  std::vector<std::string> axes, rounds;
  for (const RecordedSighting& sighting : recording.sightings) {
    axes.push_back(sighting.axis.text);
    rounds.push_back(sighting.row.round);
  }
  EXPECT_THAT(axes, ElementsAre("", "180", "180", "0", "0"));
  EXPECT_THAT(rounds, ElementsAre("", "", "2", "", "3"));
  EXPECT_THAT(recording.unused, IsEmpty());
}

// A sighting carries the instrument's current code, which is 0 if none was keyed in.
TEST(GsiReader, TakesNoAxisFromAnEmptyCodeOfASighting) {
  const auto axesOf = [](const std::string& text) {
    std::vector<std::string> axes;
    for (const RecordedSighting& sighting : readGsi(text).sightings) axes.push_back(sighting.axis.text);
    return axes;
  };
  const std::string empty = " 41....+00000000\n", turned = " 41....+00000180\n";
  EXPECT_THAT(axesOf("41....+00000180\n110001+00000001" + point + "\n110002+00000002" + point + empty +
                     "110003+00000003" + point),
              ElementsAre("180", "180", "180"));
  EXPECT_THAT(axesOf("110001+00000001" + point + empty + "110002+00000001" + point + turned +
                     "110003+00000001" + point + empty),
              ElementsAre("", "180", "0"))
      << "stated with each sighting";
}

TEST(GsiReader, EndsTheMarkOfAZeroWithASightingWithoutAngles) {
  const Recording recording =
      readGsi("41....+0000ZERO\n110001+00000005 31..00+00002405\n110002+00000001" + point);
  ASSERT_EQ(recording.sightings.size(), 1U);
  EXPECT_FALSE(recording.sightings[0].isZero);
}

TEST(GsiReader, KnowsThePointingZero) {
  const auto zeros = [](const std::string& text, const std::string& name = {}) {
    std::vector<bool> zero;
    const Recording recording = readGsi(text, name);
    for (const RecordedSighting& sighting : recording.sightings) zero.push_back(sighting.isZero);
    return zero;
  };
  EXPECT_THAT(zeros("110001+00000000" + point + "\n110001+0000zero" + point + "\n110001+00000010" + point),
              ElementsAre(true, true, false));
  EXPECT_THAT(zeros("41....+0000ZERO\n110001+00000005" + point + "\n110001+00000005" + point),
              ElementsAre(true, false));
  EXPECT_THAT(zeros("110001+00000000" + point + "\n110001+00000REF" + point, "ref"),
              ElementsAre(false, true));
}

TEST(GsiReader, TakesInstrumentAndDate) {
  const Recording recording =
      readGsi("13....+00TM5100 12....+00640054 17....+08022018\n110001+00000001" + point);
  EXPECT_EQ(recording.instrumentName, "TM5100");
  EXPECT_EQ(recording.instrumentSerial, "640054");
  EXPECT_EQ(recording.measuredOn, "2018-02-08");
  EXPECT_THAT(recording.unused, IsEmpty());
}

TEST(GsiReader, ListsWhatItDoesNotUse) {
  const Recording recording =
      readGsi("# a remark\n110001+00000001" + point + " 31..00+00002405\n110002+00000002" + point +
              " 31..00+00002405\n110003+00000009 81..00+00005387\n41....+000TREES\n@W127");
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_EQ(recording.sightings.size(), 2u);
  EXPECT_THAT(recording.unusedBySession, Contains("slope distance is not used: 2 times, first in line 2"));
  EXPECT_THAT(recording.unused, Contains("point “9” without angles is not used: line 4"));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("TREES")));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("@W127")));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("# a remark")));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("easting")));
}

TEST(GsiReader, NamesLinesThatCannotBeRead) {
  const Recording recording =
      readGsi("110001+00000001" + point + "\n\n110002+00000002 21.324+34152240\n21.3o4+34152240\n");
  EXPECT_EQ(recording.sightings.size(), 1u);
  ASSERT_EQ(recording.problems.size(), 2u);
  EXPECT_EQ(recording.problems[0].line, 3u);
  EXPECT_THAT(recording.problems[0].what, HasSubstr("vertical circle (word 22)"));
  EXPECT_EQ(recording.problems[1].line, 4u);
}

TEST(GsiReader, KeepsStationsAndDistancesForTheCheckOfAnInstrument) {
  const Recording recording = readGsi(
      "41....+0000STN7\n110001+00000001" + point + " 31..06+00123456\n16....+00000008\n110001+00000001" +
      point +
      " 32..08+01234567\n110001+0000WALL 81..00+00001000\n110001+00000P12 88..10+00001500\n110001+00000001" +
      point);
  ASSERT_EQ(recording.sightings.size(), 3u);
  EXPECT_THAT(recording.stations, ElementsAre("", "7", "8", "P12"));
  EXPECT_EQ(recording.sightings[0].station, 1u);
  EXPECT_NEAR(recording.sightings[0].distanceM, 12.3456, 1e-12);
  EXPECT_FALSE(recording.sightings[0].isDistanceHorizontal);
  EXPECT_EQ(recording.sightings[1].station, 2u);
  EXPECT_NEAR(recording.sightings[1].distanceM, 12.34567, 1e-12);
  EXPECT_TRUE(recording.sightings[1].isDistanceHorizontal);
  EXPECT_EQ(recording.sightings[2].station, 3u);
  EXPECT_THAT(recording.unusedBySession, Contains(HasSubstr("the station “7” is not used: line 1")));
  EXPECT_THAT(recording.unusedBySession, Contains(HasSubstr("slope distance is not used: line 2")));
}

std::vector<std::string> verticalsOf(const Recording& recording) {
  std::vector<std::string> angles;
  for (const RecordedSighting& sighting : recording.sightings) angles.push_back(sighting.row.vertical);
  return angles;
}

TEST(GsiReader, TellsOfWordsAndLinesThatNobodyNeeds) {
  const Recording recording =
      readGsi("Job ARC7, 22.05.2026\n110001+00000001" + point +
              " 86..+00300000 87..10+0015 71....+WIND 4F\n"
              "*110002+000000000000000P 84.+0000 21.322+0000000001250000 331.28+0000000000012345 "
              "22.322+0000000009820000\n-- page 2 --\n21 March\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_THAT(verticalsOf(recording), ElementsAre("88°16'49.0\"", "98.20000gon"));
  for (const std::string expected :
       {"the line “Job ARC7, 22.05.2026” is not used: line 1", "the text “86..+00300000”, no GSI word",
        "reflector height is not used: line 2", "the text “84.+0000”", "word 331", "the line “-- page 2 --”",
        "the line “21 March”", "neither 8 nor 16 characters, used unchanged: 1, first in line 2"})
    EXPECT_THAT(recording.unused, Contains(HasSubstr(expected)));
}

TEST(GsiReader, QuotesTheFirstLinesOfNoUseAndCountsTheOthers) {
  std::string text = "110001+00000001" + point + "\n";
  for (int i = 0; i < 50; ++i) text += "page " + std::to_string(i) + "\n";
  const Recording recording = readGsi(text);
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_EQ(recording.unused.size(), 4u);
  EXPECT_THAT(recording.unused, Contains("the line “page 2” is not used: line 4"));
  EXPECT_THAT(recording.unused,
              Contains("a further line of unknown format is not used: 47 times, first in line 5"));
}

TEST(GsiReader, RefusesALineWhereWhatIsNeededIsTorn) {
  const auto problem = [](const std::string& text) {
    const Recording recording = readGsi(text + "\n110009+00000009" + point);
    EXPECT_EQ(recording.sightings.size(), 1u) << text;
    return recording.problems.empty() ? std::string() : recording.problems.front().text();
  };
  EXPECT_THAT(problem("110001+00000001 21.324+341522 22.324+08816490"),
              HasSubstr("line 1, column 17: horizontal circle “341522” has neither 8 nor 16"));
  EXPECT_THAT(problem("110001+00000001 21.324+34152240 22..+08816490"),
              HasSubstr("column 33: “22..+08816490”"));
  EXPECT_THAT(problem("110001+00000001 21.320+34152240 22.324+08816490"), HasSubstr("no angle unit"));
  EXPECT_THAT(problem("11001+00000001" + point), HasSubstr("“11001+00000001” is no GSI word"));
  EXPECT_THAT(problem("110001+00000001 21.3"), HasSubstr("“21.3” is no GSI word")) << "a line that was cut";
  EXPECT_THAT(problem("41...+00000180"), HasSubstr("“41...+00000180” is no GSI word")) << "an axis";
  EXPECT_THAT(problem("110001+00000001" + point + " 21.324+34152240"), HasSubstr("second reading"));
  EXPECT_THAT(problem("110001+00000001 21.324+3415-240 22.324+08816490"), HasSubstr("not made of digits"));
}

TEST(GsiReader, CarriesSixtySecondsAndTellsHowMany) {
  const Recording recording = readGsi(
      "110001+00000001 21.324+10712600 22.324+08847300\n110002+00000002 21.324+35959600 "
      "22.324+08859600\n110003+00000003 21.324+10860000 22.324+08861000\n"
      "110004+00000004 21.324+10760600 22.324+08800000\n");
  ASSERT_EQ(recording.sightings.size(), 4u);
  EXPECT_EQ(recording.sightings[3].row.horizontal, "108°01'00.0\"");
  EXPECT_EQ(recording.sightings[0].row.horizontal, "107°13'00.0\"");
  EXPECT_EQ(recording.sightings[1].row.horizontal, "0°00'00.0\"");
  EXPECT_EQ(recording.sightings[2].row.horizontal, "109°00'00.0\"");
  EXPECT_THAT(verticalsOf(recording),
              ElementsAre("88°47'30.0\"", "89°00'00.0\"", "88°61'00.0\"", "88°00'00.0\""));
  EXPECT_THAT(recording.unused, ElementsAre(HasSubstr("next minute or degree: 5, first in line 1")));
}

TEST(GsiReader, ReadsEveryBlockOfALine) {
  const Recording recording =
      readGsi("110001+00000001" + point + " 110002+00000002" + point + " 410003+0AXIS180 110004+00000001" +
              point + "\n*110005+0000000000000002 21.322+0000000001250000 22.322+0000000009820000 " +
              "*110006+0000000000000003 22.322+0000000009820000 21.322+0000000001250000\n21.102+10000000 " +
              "22.102+09823456 110007+00000007\n410008+0000ZERO 110009+00000009" + point);
  EXPECT_THAT(recording.problems, IsEmpty());
  std::vector<std::string> points, axes;
  for (const RecordedSighting& sighting : recording.sightings) {
    points.push_back(sighting.row.point);
    axes.push_back(sighting.axis.text);
  }
  EXPECT_THAT(points, ElementsAre("1", "2", "1", "2", "3", "7", "9"));
  EXPECT_THAT(axes, ElementsAre("", "", "180", "180", "180", "180", "180"));
  EXPECT_TRUE(recording.sightings.back().isZero);
  EXPECT_FALSE(recording.sightings.front().isZero);
}

TEST(GsiReader, TakesACodeInABlockForItsSighting) {
  const Recording recording =
      readGsi("110001+00000001" + point + " 41....+0000ZERO\n110002+00000002" + point);
  ASSERT_EQ(recording.sightings.size(), 2u);
  EXPECT_TRUE(recording.sightings[0].isZero);
  EXPECT_FALSE(recording.sightings[1].isZero);
}

TEST(GsiReader, KnowsStationsByTheCodesOfInstruments) {
  const Recording recording =
      readGsi("410001+00000021 42....+000000K1 43....+00001500\n110002+00000001" + point +
              "\n410003+00000002 42....+00000100\n110004+00000001" + point +
              "\n410005+00000003 42....+00001546\n110006+00000001" + point + "\n410007+00000021\n");
  EXPECT_THAT(recording.stations, ElementsAre("", "K1", "100"));
  ASSERT_EQ(recording.sightings.size(), 3u);
  EXPECT_EQ(recording.sightings[0].station, 1u);
  EXPECT_EQ(recording.sightings[2].station, 2u) << "code 3 is the height of the target";
}

TEST(GsiReader, TellsWhatWasNotMeasured) {
  const Recording recording = readGsi(
      "110001+00000001 21.102+11912345 22.112+09823456\n110002+00000002 21.112+11912345 "
      "22.142+09823456\n110003+00000003 21.322+11912345 22.332+09823456\n");
  EXPECT_EQ(recording.sightings.size(), 3u);
  EXPECT_THAT(recording.unused, Contains("angles keyed in by hand, not measured: 2, first in line 1"));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("worked out, not measured: 1, first in line 2")));
}

// 0°00'23.40" next to a zenith angle that shows the place of the sign; 107.12234 has it after the degrees.
TEST(GsiReader, ReadsAWrittenDecimalSign) {
  const Recording recording = readGsi(
      "*110001+0000000000000001 21.324+00000000000023.40 22.324+00000000884731.50\n"
      "*110002+0000000000000002 21.324+00000000107.12234 22.324+00000000088.47600\n"
      "*110003+0000000000000003 21.322+00000000119.12345 22.323+00000000088.79167\n"
      "110004+00000004 21.325+1600,0000 22.324+881649.5\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 4u);
  std::vector<std::string> horizontals;
  for (const RecordedSighting& sighting : recording.sightings) horizontals.push_back(sighting.row.horizontal);
  EXPECT_THAT(horizontals, ElementsAre("0°00'23.40\"", "107°12'23.4\"", "119.12345gon", "90.000000000°"));
  EXPECT_THAT(verticalsOf(recording),
              ElementsAre("88°47'31.50\"", "88°48'00.0\"", "88.79167°", "88°16'49.5\""));
}

TEST(GsiReader, ReadsWhatProgramsMakeOfBlocks) {
  const std::string first = "110001+00000001", hz = "21.102+11912345", v = "22.102+09823456";
  for (const std::string& text : {first + "," + hz + "," + v, first + hz + v, first + "\t" + hz + "\t\t" + v,
                                  "12: " + first + " " + hz + " " + v, first + " " + hz + " " + v + "*5A",
                                  first + " " + hz + " " + v + " 1234", first + ";" + hz + ";" + v + ";"}) {
    const Recording recording = readGsi(text);
    EXPECT_THAT(recording.problems, IsEmpty()) << text;
    ASSERT_EQ(recording.sightings.size(), 1u) << text;
    EXPECT_EQ(recording.sightings[0].row.horizontal, "119.12345gon");
    EXPECT_EQ(recording.sightings[0].row.vertical, "98.23456gon");
    EXPECT_EQ(recording.sightings[0].row.point, "1");
  }
}

TEST(GsiReader, StopsAtTheEndOfADosFile) {
  const std::string line = "110001+00000001" + point + "\r\n";
  EXPECT_THAT(readGsi(line + "\x1A").unused, Contains(HasSubstr("after the end of the file (^Z)")));
  EXPECT_EQ(readGsi(line + "\x1A" + line).sightings.size(), 1u);
}

}  // namespace
}  // namespace alidade::test
