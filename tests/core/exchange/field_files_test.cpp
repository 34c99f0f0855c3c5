#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/exchange/import.h"
#include "tests/support/file_content.h"

// The files of tests/reference/import, whose README describes each of them.

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The rows of a file as `point horizontal vertical`, and its remarks.
struct ReadFile {
  std::vector<std::string> rows, remarks;
  std::string refusal;
  Session session;
};

ReadFile readFile(const std::string& name) {
  const std::string bytes = contentOf(std::filesystem::path(ALIDADE_REFERENCE_DIR) / "import" / name);
  const Result<Import> import = importReadings({{.name = {}, .bytes = bytes}});
  ReadFile read;
  if (!import) {
    read.refusal = import.problem().what;
    return read;
  }
  EXPECT_TRUE(import->problems.empty()) << name << ": " << import->problems.front().text();
  read.remarks = import->remarks;
  read.session = import->session;
  for (const Position& position : import->session.positions)
    for (const Reading& row : position.readings)
      read.rows.push_back(row.point + " " + row.horizontal + " " + row.vertical);
  return read;
}

TEST(FieldFiles, CarrySixtySeconds) {
  const ReadFile read = readFile("gsi-60-seconds.gsi");
  EXPECT_THAT(read.rows, ElementsAre("1 107°13'00.0\" 88°47'30.0\"", "2 108°01'20.0\" 88°54'00.0\"",
                                     "3 109°00'00.0\" 89°01'10.0\""));
  EXPECT_THAT(read.remarks,
              Contains(HasSubstr("60 seconds or minutes, read as the next minute or degree: 3")));
}

TEST(FieldFiles, PassOverAWordThatNobodyUses) {
  const ReadFile read = readFile("gsi-bad-unused-word.gsi");
  EXPECT_EQ(read.rows.size(), 2u);
  EXPECT_THAT(read.remarks, Contains(HasSubstr("“86..+0000000000300000”, no GSI word, is not used: line 1")));
}

TEST(FieldFiles, TakeAFullCircleForZero) {
  EXPECT_THAT(readFile("gsi-full-circle.gsi").rows,
              ElementsAre("1 0°00'00.0\" 88°47'30.0\"", "2 0.00000gon 98.20000gon"));
}

TEST(FieldFiles, ReadAWrittenDecimalSign) {
  EXPECT_THAT(readFile("gsi-written-point.gsi").rows,
              ElementsAre("1 107°12'23.40\" 88°47'31.50\"", "2 108°01'12.00\" 88°53'22.10\""));
}

TEST(FieldFiles, CountCharactersNotBytes) {
  const ReadFile latin = readFile("gsi-umlaut-latin1.gsi");
  EXPECT_THAT(latin.rows, ElementsAre("1 119.12345gon 98.23456gon"));
  EXPECT_EQ(latin.session.positions.at(0).readings.at(0).note, "BÖDEN1Ä");
  const ReadFile utf8 = readFile("gsi-umlaut-utf8.gsi");
  EXPECT_THAT(utf8.rows, ElementsAre("1 119.12345gon 98.23456gon", "2 119.12345gon 98.23456gon"));
  EXPECT_EQ(utf8.session.positions.at(0).readings.at(1).note, "ÄB2");
  const ReadFile chinese = readFile("gsi-names-gbk.gsi");
  EXPECT_THAT(chinese.rows, ElementsAre("1 119.12345gon 98.23456gon", "2 120.12345gon 98.33456gon"));
  EXPECT_EQ(chinese.session.positions.at(0).readings.at(1).note, "点位2");
  EXPECT_THAT(readFile("gsi-utf16.gsi").rows, ElementsAre("1 106°52'30.0\" 88°16'49.0\""));
}

TEST(FieldFiles, ReadEveryBlockOfALine) {
  EXPECT_THAT(readFile("gsi-two-blocks-in-a-line.gsi").rows,
              ElementsAre("1 119.12345gon 98.23456gon", "2 120.12345gon 98.33456gon"));
}

TEST(FieldFiles, EndAtTheSignOfDos) {
  EXPECT_EQ(readFile("gsi-ctrl-z.gsi").rows.size(), 2u);
  const ReadFile mixed = readFile("sdr-mixed-means-ctrl-z.sdr");
  EXPECT_THAT(mixed.rows, ElementsAre("1 12.50000000° 88.20000000°", "1 192.50000000° 271.80000000°"));
  EXPECT_THAT(mixed.remarks, Contains(HasSubstr("(09MC) is not used: line 7")));
  EXPECT_THAT(mixed.remarks, Contains(HasSubstr("after the end of the file (^Z) is not used: line 8")));
}

TEST(FieldFiles, TellOfAHeading) {
  const ReadFile read = readFile("gsi-heading-line.gsi");
  EXPECT_EQ(read.rows.size(), 2u);
  EXPECT_THAT(read.remarks, Contains("the line “Job ARC7, exported 5 March” is not used: line 1"));
}

TEST(FieldFiles, PassOverWhatTransmissionsAdd) {
  const ReadFile read = readFile("gsi-transmission.gsi");
  EXPECT_THAT(read.rows, ElementsAre("1 69.444393750° 88.987500000°", "2 69.999997500° 88.999998750°"));
  EXPECT_THAT(read.remarks, Contains(HasSubstr("the text “4F”, no GSI word")));
}

TEST(FieldFiles, PassOverRecordsThatNobodyUses) {
  const ReadFile deleted = readFile("sdr-deleted-record.sdr"),
                 collimation = readFile("sdr-collimation-record.sdr");
  EXPECT_EQ(deleted.rows.size(), 4u);
  EXPECT_EQ(collimation.rows, deleted.rows) << "raw readings, the collimation is not applied";
  EXPECT_THAT(deleted.remarks, Contains("a deleted record is not used: line 9"));
  EXPECT_THAT(collimation.remarks, Contains("the collimation of the instrument (04) is not used: line 5"));
}

TEST(FieldFiles, AskForRawObservations) {
  EXPECT_THAT(readFile("sdr-only-means.sdr").refusal, HasSubstr("send the observations raw"));
}

TEST(FieldFiles, TellStations) {
  for (const std::string name : {"sdr-two-stations.sdr", "gsi-station-codes.gsi"}) {
    const ReadFile read = readFile(name);
    EXPECT_EQ(read.rows.size(), 16u);
    EXPECT_THAT(read.remarks, Contains(HasSubstr("the station “K1” is not used")));
    EXPECT_THAT(read.remarks, Contains(HasSubstr("the station “K2” is not used")));
  }
}

TEST(FieldFiles, TellOfABacksightToPointZero) {
  const ReadFile read = readFile("m5-backsight-0.m5");
  EXPECT_THAT(read.rows, ElementsAre("1 107.1250gon 98.4730gon"));
  EXPECT_EQ(read.session.positions.at(0).zero.horizontal, "101.1250gon");
  EXPECT_THAT(read.remarks, Contains(HasSubstr("taken as the pointing zero: 1, first in line 2")));
}

}  // namespace
}  // namespace alidade::test
