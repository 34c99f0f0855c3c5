#include "core/exchange/sdr_reader.h"

#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string filled(const std::string& text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

/// Version, four digits, date and time, then the units: angles, distances, pressure, temperature, order,
/// direction.
std::string heading(const std::string& version, const std::string& units, const std::string& end = "\r\n") {
  return "00NM" + filled(version, 16) + "0000" + filled("04-Oct-26 10:00", 16) + units + end;
}

std::string instrument(char circle) {
  return "01NM:" + filled("SET5F V01-00", 16) + "020078" + filled("SET5F", 16) + "020078" + "3" + circle +
         "\r\n";
}

/// A record of SDR33: fields of 16 characters.
std::string record(const std::string& kind, const std::vector<std::string>& fields,
                   const std::string& end = "\r\n") {
  std::string text = kind;
  for (const std::string& field : fields) text += filled(field, 16);
  return text + end;
}

/// A record of SDR2x: points have 4 characters, numbers 10.
std::string shortRecord(const std::string& from, const std::string& to, const std::string& distance,
                        const std::string& vertical, const std::string& horizontal) {
  return "09F1" + filled(from, 4) + filled(to, 4) + filled(distance, 10) + filled(vertical, 10) +
         filled(horizontal, 10) + "\r\n";
}

TEST(SdrReader, ReadsBothFacesWithTheirUnit) {
  const Recording recording =
      readSdr("\x02\r\n" + heading("SDR33 V04-04.02", "211111") + "10NM" + filled("JOB", 16) + "121111\r\n" +
              instrument('1') + record("02TP", {"ST1", "0.000", "0.000", "0.000", "1.552"}) +
              record("03NM", {"1.70000000"}) +
              record("09F1", {"ST1", "101", "63.2140", "101.23450000", "87.43210000", "SLIDE"}) +
              record("09F2", {"ST1", "101", "63.2160", "298.76710000", "287.43370000"}) +
              record("09MD", {"ST1", "102", "", "100.44", "120.555"}) +
              "\x03"
              "09436\r\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_THAT(recording.unused, IsEmpty());
  EXPECT_EQ(recording.format, "SDR33");
  EXPECT_EQ(recording.instrumentName, "SET5F V01-00");
  EXPECT_EQ(recording.instrumentSerial, "020078");
  EXPECT_EQ(recording.verticalCircle, "zenith");
  ASSERT_EQ(recording.sightings.size(), 3u);
  const Reading& first = recording.sightings[0].row;
  EXPECT_EQ(first.point, "101");
  EXPECT_EQ(first.face, "1");
  EXPECT_EQ(first.horizontal, "87.43210000gon");
  EXPECT_EQ(first.vertical, "101.23450000gon");
  EXPECT_EQ(first.note, "SLIDE");
  EXPECT_EQ(recording.sightings[0].line, 7u);
  EXPECT_EQ(recording.sightings[0].columnOf(rowField(&Reading::horizontal)), 69u);
  EXPECT_EQ(recording.sightings[1].row.face, "2");
  EXPECT_EQ(recording.sightings[2].row.face, "");
}

TEST(SdrReader, ReadsTheOlderFormatAndDecimalDegrees) {
  const Recording recording = readSdr(heading("SDR20 V03-05", "111111", "\n") + instrument('2') +
                                      shortRecord("0001", "1001", "234.567813", "5.98888810", "81.0000000"));
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_EQ(recording.format, "SDR2x");
  EXPECT_EQ(recording.verticalCircle, "elevation");
  ASSERT_EQ(recording.sightings.size(), 1u);
  EXPECT_EQ(recording.sightings[0].row.point, "1001");
  EXPECT_EQ(recording.sightings[0].row.vertical, "5.98888810°");
  EXPECT_EQ(recording.sightings[0].row.horizontal, "81.0000000°");
}

TEST(SdrReader, TakesMarksFromNotes) {
  const Recording recording = readSdr(heading("SDR33 V04-04.02", "111111") +
                                      "13NMAXIS 180\r\n13NMROUND 2\r\n13TSTime Date 06/07/2022\r\n" +
                                      "13NMZERO\r\n" + record("09F1", {"S", "9", "", "90.0", "332.5"}) +
                                      record("09F1", {"S", "10", "", "91.0", "341.5"}) + "13NMwind\r\n");
  ASSERT_EQ(recording.sightings.size(), 2u);
  EXPECT_TRUE(recording.sightings[0].isZero);
  EXPECT_FALSE(recording.sightings[1].isZero);
  EXPECT_EQ(recording.sightings[1].axis.text, "180");
  EXPECT_EQ(recording.sightings[1].row.round, "2");
  EXPECT_THAT(recording.unused, ::testing::ElementsAre("the note “wind” is not used: line 8"));
}

TEST(SdrReader, SaysWhatIsNoReadingOfACircle) {
  const Recording recording =
      readSdr(heading("SDR33 V04-04.02", "111111") + record("09MC", {"S", "9", "1", "90.0", "332.5"}) +
              record("08TP", {"9", "1", "2", "3"}) + record("02TP", {"S"}) + record("02TP", {"T"}) +
              record("09F1", {"T", "9", "", "90.0", "332.5"}));
  EXPECT_EQ(recording.sightings.size(), 1u);
  EXPECT_THAT(recording.unused, Contains(HasSubstr("09MC")));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("coordinates (08)")));
  EXPECT_THAT(recording.stations, ::testing::ElementsAre("", "S", "T"));
  EXPECT_EQ(recording.sightings.at(0).station, 2u);
  EXPECT_THAT(recording.unusedBySession, Contains("the station “T” is not used: line 5"));
}

TEST(SdrReader, NamesRecordsThatCannotBeRead) {
  const std::string sound = record("09F1", {"S", "9", "", "90.0", "332.5"});
  const auto problem = [&](const std::string& text) {
    const Recording recording = readSdr(text + sound);
    return recording.problems.empty() ? std::string() : recording.problems.front().text();
  };
  EXPECT_THAT(problem(heading("SDR33", "311111")),
              HasSubstr("line 1, column 41: “3” is not a supported unit of angles"));
  EXPECT_THAT(problem(heading("SDR33", "111112")), HasSubstr("increase to the left"));
  EXPECT_THAT(problem("00NMSDR33\n"), HasSubstr("line 1, column 10: “”")) << "where the line ends";
  const std::string begin = heading("SDR33", "111111");
  EXPECT_THAT(problem(begin + record("09F1", {"S", "9", "", "", "332.5"})),
              HasSubstr("line 2, column 53: has no vertical reading"));
  EXPECT_THAT(problem(begin + record("09F1", {"S", "9", "", "90.0", "33x.5"})),
              HasSubstr("“33x.5” is no number"));
  EXPECT_THAT(problem(begin + record("O9F1", {"S", "9", "", "90.0", "332.5"})), HasSubstr("is no record"));
  EXPECT_THAT(problem(begin + instrument('1') + sound + begin + instrument('2')), HasSubstr("other kind"));
  EXPECT_EQ(readSdr(heading("SDR33", "311111") + sound).sightings.size(), 0u) << "a job in mils is not read";
}

TEST(SdrReader, FollowsTheStationOfEachObservation) {
  const auto stations = [](const Recording& recording) {
    std::vector<std::string> names;
    for (const RecordedSighting& sighting : recording.sightings)
      names.push_back(recording.stations.at(sighting.station));
    return names;
  };
  const Recording recording = readSdr(
      heading("SDR33", "111111") + record("02TP", {"K1"}) + record("09F1", {"K1", "9", "", "90.0", "332.5"}) +
      record("09F1", {"K2", "9", "", "90.0", "2.5"}) + record("09F1", {"", "9", "", "90.0", "2.5"}));
  EXPECT_THAT(stations(recording), ::testing::ElementsAre("K1", "K2", "K2"));
  EXPECT_THAT(recording.unusedBySession, Contains("the station “K1” is not used: line 2"));
  const Recording older =
      readSdr(heading("SDR20 V03-05", "211111") + shortRecord("0001", "1001", "", "100.5", "10") +
              shortRecord("0002", "1001", "", "100.5", "360.5"));
  EXPECT_THAT(stations(older), ::testing::ElementsAre("0001", "0002"));
}

TEST(SdrReader, TellsOfRecordsThatNobodyNeeds) {
  const Recording recording =
      readSdr("Job ARC7\n" + heading("SDR33", "111111") + record("DD09F1", {"S", "8", "", "90.0", "1.5"}) +
              record("04NM", {"0.0005", "-0.0008"}) + "66ZZ something\n" + "what\n" +
              record("09ZZ", {"S", "9", "", "90.0", "332.5"}) + record("12NM", {"S"}) +
              record("09MC", {"S", "9", "1", "90.0", "332.5"}) +
              record("09F1", {"S", "9", "", "90.0", "360.00000000"}) + "\x03\n09436\n4711\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 1u);
  EXPECT_EQ(recording.sightings[0].row.horizontal, "0.00000000°") << "a full turn";
  for (const std::string expected :
       {"the line “Job ARC7”", "a deleted record is not used: line 3", "collimation of the instrument (04)",
        "unknown type “66”", "the line “what”", "not raw (09ZZ)", "a set (12)", "(09MC)"})
    EXPECT_THAT(recording.unused, Contains(HasSubstr(expected)));
}

// Columns after names beyond ASCII: characters of Latin-1, bytes of GB 18030 (two for a character), bytes of
// UTF-8.
TEST(SdrReader, FindsTheColumnsBehindNamesOfAnyEncoding) {
  const std::string before = heading("SDR33", "111111") + "09F1" + filled("K1", 16),
                    behind =
                        filled("", 16) + filled("90.12345678", 16) + filled("332.5", 16) + filled("Höhe", 18);
  for (const std::string& name : {"BÖDEN" + std::string(11, ' '), "点位1" + std::string(11, ' '),
                                  "BÖDEN" + std::string(10, ' '), "点位1" + std::string(9, ' ')}) {
    const Recording recording = readSdr(before + name + behind + "\n");
    ASSERT_EQ(recording.sightings.size(), 1u) << name;
    EXPECT_EQ(recording.sightings[0].row.vertical, "90.12345678°") << name;
    EXPECT_EQ(recording.sightings[0].row.horizontal, "332.5°");
    EXPECT_EQ(recording.sightings[0].row.point, name.substr(0, name.find(' ')));
  }
}

TEST(SdrReader, AsksForRawObservations) {
  const Recording recording =
      readSdr(heading("SDR33", "111111") + record("09MC", {"S", "9", "1", "90.0", "332.5"}));
  ASSERT_EQ(recording.problems.size(), 1u);
  EXPECT_THAT(recording.problems[0].text(), HasSubstr("line 2: is a corrected mean (09MC)"));
  EXPECT_THAT(recording.problems[0].text(), HasSubstr("send the observations raw"));
}

TEST(SdrReader, ReadsLinesThatWereCutAndSurvivesAnyCut) {
  const std::string text = heading("SDR33", "111111") + record("09F1", {"S", "9", "", "90.0", "332.5"}, "");
  for (std::size_t length = 0; length <= text.size(); ++length)
    EXPECT_LE(readSdr(text.substr(0, length)).sightings.size(), 1u);
  std::string cut = text;
  while (cut.back() == ' ') cut.pop_back();
  EXPECT_EQ(readSdr(cut).sightings.at(0).row.horizontal, "332.5°");
}

}  // namespace
}  // namespace alidade::test
