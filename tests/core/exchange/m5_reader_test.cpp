#include "core/exchange/m5_reader.h"

#include <gmock/gmock.h>

#include "core/base/angle_text.h"
#include "core/exchange/text_lines.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}
std::string rightAligned(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

/// One of the three numbers of a line: type at 1-2, value at 4-17, unit at 19-22.
std::string number(const std::string& type, const std::string& value, const std::string& unit) {
  return padded(type, 2) + " " + rightAligned(value, 14) + " " + padded(unit, 4);
}
const std::string nothing = number("", "", "");

/// A line of 119 characters before its end, as the user guide of the Trimble M3 has it.
std::string line(int address, const std::string& type, const std::string& text, const std::string& numbers,
                 char error = ' ') {
  std::string adr = std::to_string(address);
  adr = std::string(5 - adr.size(), '0') + adr;
  std::string all = "For M5|Adr " + adr + "|" + padded(type, 3) + " " + padded(text, 27) + "|";
  for (std::size_t i = 0; i < 3; ++i) all += numbers.substr(i * nothing.size(), nothing.size()) + "|";
  return all + error + "\r\n";
}

std::string sighting(const std::string& name, const std::string& horizontal, const std::string& vertical,
                     const std::string& unit, const std::string& system = "V1") {
  return line(1, "PI1", rightAligned(name, 27),
              nothing + number("Hz", horizontal, unit) + number(system, vertical, unit));
}

TEST(M5Reader, LinesOfTheTestHaveThePublishedColumns) {
  const std::string text = sighting("7", "34.9078", "106.3481", "gon");
  ASSERT_EQ(text.size(), 121u);
  EXPECT_EQ(text.substr(0, 10), "For M5|Adr");
  EXPECT_EQ(text.substr(17, 3), "PI1");
  EXPECT_EQ(text[47], '7');
  EXPECT_EQ(text.substr(72, 2), "Hz");
  EXPECT_EQ(text.substr(82, 7), "34.9078");
  EXPECT_EQ(text.substr(90, 3), "gon");
  EXPECT_EQ(text.substr(95, 2), "V1");
}

TEST(M5Reader, ReadsSightingsInEveryUnit) {
  const Recording recording =
      readM5(sighting("1", "34.9078", "106.3481", "gon") + sighting("2", "7.5439", "89.1413", "DMS") +
             sighting("3", "341.873333", "88.280278", "DEG") + sighting("4", "6400.0", "1600.0000", "mil"));
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_EQ(recording.format, "M5");
  EXPECT_EQ(recording.verticalCircle, "zenith");
  ASSERT_EQ(recording.sightings.size(), 4u);
  EXPECT_EQ(recording.sightings[0].row.horizontal, "34.9078gon");
  EXPECT_EQ(recording.sightings[0].row.vertical, "106.3481gon");
  EXPECT_EQ(recording.sightings[1].row.horizontal, "7 54 39");
  EXPECT_EQ(recording.sightings[1].row.vertical, "89 14 13");
  EXPECT_EQ(recording.sightings[2].row.vertical, "88.280278°");
  EXPECT_DOUBLE_EQ(parseAngle(recording.sightings[3].row.horizontal)->degrees(), 0) << "a full turn";
  EXPECT_DOUBLE_EQ(parseAngle(recording.sightings[3].row.vertical)->degrees(), 90);
  EXPECT_EQ(recording.sightings[3].row.point, "4");
  EXPECT_EQ(recording.sightings[3].line, 4u);
  EXPECT_EQ(recording.sightings[0].columnOf(rowField(&Reading::horizontal)), 83u);
  EXPECT_EQ(recording.sightings[0].columnOf(rowField(&Reading::point)), 48u);
}

// The lines of the manual's electronic field book as printed in GeoEasy's documentation.
TEST(M5Reader, ReadsAPublishedFieldBook) {
  const Recording recording = readM5(
      "For M5|Adr 00017|TI      EL STAT                |                      |                      |       "
      " "
      "              |\n"
      "For M5|Adr 00019|PI1           A               2|SD          7.674 m   |Hz         7.5439 DMS |V1     "
      " "
      "  89.1413 DMS |\n"
      "For M5|Adr 00020|PI1           S               A|                      |                      |Z      "
      " "
      "   -0.102 m   |\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 1u);
  EXPECT_EQ(recording.sightings[0].row.point, "2");
  EXPECT_EQ(recording.sightings[0].row.note, "A");
  EXPECT_EQ(recording.sightings[0].row.horizontal, "7 54 39");
  EXPECT_THAT(recording.unused, Contains(HasSubstr("EL STAT")));
  EXPECT_THAT(recording.unused, Contains(HasSubstr("distance")));
}

TEST(M5Reader, FollowsTheHeadingAndTheMarks) {
  const Recording recording = readM5(
      line(1, "TI", "START", number("01", "M3 3\"DR", "") + number("02", "131500", "") + nothing) +
      line(2, "TI", "", number("20", "1", "") + number("21", "11", "") + number("22", "16", "")) +
      sighting("0", "332.3254", "89.5957", "DMS") + line(3, "TI", "AXIS 180", nothing + nothing + nothing) +
      line(4, "TI", "ROUND2", nothing + nothing + nothing) +
      line(5, "PI1", "note      CODE1  A 12",
           nothing + number("Hz", "1.0", "gon") + number("V1", "100", "gon")) +
      "END\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_EQ(recording.instrumentName, "M3 3\"DR");
  EXPECT_EQ(recording.instrumentSerial, "131500");
  ASSERT_EQ(recording.sightings.size(), 2u);
  EXPECT_TRUE(recording.sightings[0].isZero);
  EXPECT_EQ(recording.sightings[1].axis.text, "180");
  EXPECT_EQ(recording.sightings[1].row.round, "2");
  EXPECT_EQ(recording.sightings[1].row.point, "A 12") << "from column 16 of the text on";
  EXPECT_EQ(recording.sightings[1].row.note, "note      CODE1");
}

// 59.96″ rounded to whole seconds.
TEST(M5Reader, CarriesSixtySecondsAndMinutes) {
  const Recording recording =
      readM5(sighting("1", "107.1260", "88.4730", "DMS") + sighting("2", "108.0120", "88.5960", "DMS") +
             sighting("3", "359.5960", "89.1250", "DMS") + sighting("4", "359.5960", "89.60125", "DMS") +
             sighting("5", "360.0000", "88.1361", "DMS") + sighting("6", "400.0000", "360", "gon"));
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 6u);
  EXPECT_EQ(recording.sightings[0].row.horizontal, "107 13 00");
  EXPECT_EQ(recording.sightings[0].row.vertical, "88 47 30");
  EXPECT_EQ(recording.sightings[1].row.vertical, "89 00 00");
  EXPECT_EQ(recording.sightings[2].row.horizontal, "0 00 00");
  EXPECT_EQ(recording.sightings[3].row.vertical, "90 00 12.5");
  EXPECT_EQ(recording.sightings[4].row.horizontal, "0 00 00") << "a full turn";
  EXPECT_FALSE(parseAngle(recording.sightings[4].row.vertical)) << "61 seconds are none";
  EXPECT_EQ(recording.sightings[5].row.horizontal, "0.0000gon");
  EXPECT_EQ(recording.sightings[5].row.vertical, "360gon") << "no full turn in gon";
  EXPECT_THAT(recording.unused, Contains(HasSubstr("next minute or degree: 5, first in line 1")));
}

TEST(M5Reader, TellsStationsByTheirPrograms) {
  const std::string none = nothing + nothing + nothing,
                    angles = nothing + number("Hz", "1.0", "gon") + number("V1", "100", "gon");
  const Recording recording =
      readM5(line(1, "TI", "KN STAT", none) +
             line(2, "PI1", "          S               A",
                  number("Y", "0.000", "m") + number("X", "0.000", "m") + nothing) +
             line(3, "PI1", "          A               0", angles) + line(4, "TI", "POLAR", none) +
             sighting("7", "1.0", "100", "gon") + line(5, "TI", "UN STAT", none) +
             sighting("7", "51.0", "100", "gon") + line(6, "TI", "EL STAT", none) +
             line(7, "PI1", "          S               A", none) + sighting("7", "51.0", "100", "gon") +
             line(8, "TI", "STATION 5", none) + sighting("7", "52.0", "100", "gon"));
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_THAT(recording.stations, ElementsAre("", "KN STAT 1", "A", "UN STAT 2", "5"));
  std::vector<std::size_t> stations;
  for (const RecordedSighting& each : recording.sightings) stations.push_back(each.station);
  EXPECT_THAT(stations, ElementsAre(2u, 2u, 3u, 3u, 4u));
  EXPECT_TRUE(recording.sightings[0].isZero);
  EXPECT_THAT(recording.unused, Contains(HasSubstr("taken as the pointing zero: 1, first in line 3")));
}

TEST(M5Reader, TellsOfLinesThatNobodyNeeds) {
  const std::string bare = sighting("7", "1.0", "100", "gon").substr(17);  // without its address
  const Recording recording =
      readM5("Field book of 5 March\n" + sighting("1", "1.0", "100", "gon") + "For M5|" + bare +
             line(2, "TI", "POLAR", nothing + nothing + nothing, 'e') + "END\n12345\n");
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 2u);
  EXPECT_EQ(recording.sightings[1].row.point, "7");
  EXPECT_THAT(recording.unused, Contains(HasSubstr("the line “Field book of 5 March”")));
  EXPECT_EQ(readM5(bare).problems.size(), 1u) << "a sighting without the mark of the format";
}

TEST(M5Reader, TakesHeightAnglesForAnElevationCircle) {
  const Recording recording = readM5(sighting("1", "1.0", "-5.2500", "gon", "V3"));
  EXPECT_EQ(recording.verticalCircle, "elevation");
  EXPECT_EQ(recording.sightings.at(0).row.vertical, "-5.2500gon");
}

TEST(M5Reader, NamesLinesThatCannotBeRead) {
  const auto problem = [](const std::string& text) {
    const Recording recording = readM5(text);
    return recording.problems.empty() ? std::string() : recording.problems.front().text();
  };
  EXPECT_THAT(problem(sighting("1", "1.0", "90", "gon", "V2")), HasSubstr("neither a zenith angle (V1)"));
  EXPECT_THAT(problem(sighting("1", "1.0", "10", "gon", "V4")), HasSubstr("V4"));
  EXPECT_THAT(problem(sighting("1", "1.x", "90", "gon")),
              HasSubstr("line 1, column 87: “1.x gon” is no angle"));
  EXPECT_THAT(problem(sighting("1", "1.0", "90", "rad")), HasSubstr("“1.0 rad”"));
  EXPECT_THAT(problem(line(1, "PI1", "1", nothing + nothing + number("Hz", "1", "gon"))),
              HasSubstr("has no vertical circle"));
  EXPECT_THAT(
      problem(line(1, "PI1", "1", nothing + number("Hz", "1", "gon") + number("V1", "100", "gon"), 'e')),
      HasSubstr("error of the instrument"));
  EXPECT_THAT(problem(sighting("1", "1", "90", "DEG") + sighting("2", "1", "0", "DEG", "V3")),
              HasSubstr("line 2"));
  EXPECT_THAT(problem("For M5|Adr\n"), HasSubstr("does not have the form"));
}

TEST(M5Reader, CutsNothingShortOfItsBars) {
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    std::string text = sighting("1", "341.5224", "88.1649", "DMS");
    text = text.substr(0, text.find('\r'));
    for (; text.back() != '|'; text.pop_back()) {
    }
    const Recording recording = readM5(text + end + text + end);
    EXPECT_EQ(recording.sightings.size(), 2u);
    EXPECT_THAT(recording.problems, IsEmpty());
  }
  for (std::size_t length = 0; length < 121; ++length) {
    const Recording recording = readM5(sighting("1", "341.5224", "88.1649", "DMS").substr(0, length));
    EXPECT_LE(recording.sightings.size(), 1u) << length;
  }
}

}  // namespace
}  // namespace alidade::test
