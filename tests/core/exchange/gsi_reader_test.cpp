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
      readGsi("110001+00000001" + point + "\n\n110002+00000002 21.324+34152240\nwhat\n");
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

}  // namespace
}  // namespace alidade::test
