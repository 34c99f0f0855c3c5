#include "core/series/instrument_check/check_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/limits.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Result<CheckReadings> readOf(const std::string& text, const CheckFileOptions& options = {}) {
  return readCheckFiles({{"hall.csv", text}}, options);
}

std::string problemOf(const std::string& text) {
  const auto readings = readOf(text);
  return readings ? "" : readings.problem().text();
}

TEST(CheckFiles, ReadATableWithStationsAndDistances) {
  const auto readings = readOf(
      "station;set;target;face;Hz [gon];V [gon];slope distance [m]\n"
      "P1;1;A;I;0.0010;98.5;12.5\nP1;1;A;II;200.0020;301.5;12.5\nP2;1;A;I;399.9999;100;\n");
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_THAT(readings->stations, ElementsAre("hall", "P1", "P2"));
  ASSERT_EQ(readings->readings.size(), 3U);
  EXPECT_EQ(readings->readings[1].face, 2);
  EXPECT_NEAR(readings->readings[1].horizontal.degrees(), 180.0018, 1e-10);
  EXPECT_EQ(readings->readings[0].distanceM, 12.5);
  EXPECT_EQ(readings->readings[2].distanceM, 0);
  EXPECT_EQ(completeRounds(*readings).size(), 2U) << "the station without a name has no readings";
}

TEST(CheckFiles, ReadGsiWithStationsByCodeAndByCoordinates) {
  const std::string sightings =
      "110001+0000000A 21.322+01000000 22.322+09000000 31..00+00012500\n"
      "110002+0000000A 21.322+21000100 22.322+31000300 31..00+00012500\n";
  const auto readings =
      readCheckFiles({{"a.gsi", "41....+00000STN 42....+00000007\n" + sightings +
                                    "110003+00000P12 84..10+00001000 85..10+00002000\n" + sightings}});
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_THAT(readings->stations, ElementsAre("a", "7", "P12"));
  EXPECT_EQ(readings->readings[2].station, 2U);
  EXPECT_EQ(readings->readings[0].distanceM, 12.5);
  const auto rounds = completeRounds(*readings);
  ASSERT_EQ(rounds.size(), 2U);
  // Face 1 reads 0.00100 gon = 3.24″ less, and the zeniths close to 0.00300 gon beyond 400. Half of each is
  // expected.
  EXPECT_NEAR(rounds[0].rounds[0].pairs[0].halfDirection.arcseconds(), -1.62, 1e-6);
  EXPECT_NEAR(rounds[0].rounds[0].pairs[0].halfVertical.arcseconds(), 4.86, 1e-6);
}

TEST(CheckFiles, TakeSeveralFilesForSeveralStations) {
  const std::string table = "target,hz,v\nA,10°00'00\",80°00'00\"\nA,190°00'00\",280°00'00\"\n";
  std::string other = table;
  other.replace(other.find("10°"), 2, "70");
  other.replace(other.find("190°"), 3, "250");
  const auto readings = readCheckFiles({{"/data/first.csv", table}, {"second.csv", other}});
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_THAT(readings->stations, ElementsAre("first", "second"));
  EXPECT_EQ(completeRounds(*readings).size(), 2U);
  // The same readings twice would count as twice as many.
  const auto copies = readCheckFiles({{"first.csv", table}, {"copy.csv", table}});
  ASSERT_FALSE(copies);
  EXPECT_THAT(copies.problem().text(), HasSubstr("has the readings of “first.csv” once more"));
}

TEST(CheckFiles, AreOfOneInstrument) {
  const auto file = [](const char* serial, const char* day, const char* angle) {
    return std::string("12....+0000") + serial + " 17....+0" + day + "2026\n110001+0000000A 21.324+" + angle +
           "0000 22.324+09000000\n110002+0000000A 21.324+" + std::to_string(std::stoi(angle) + 180) +
           "0000 22.324+27000000\n";
  };
  const std::string first = file("1111", "103", "1000"), later = file("1111", "104", "1001"),
                    other = file("2222", "103", "1002");
  const auto refused = readCheckFiles({{"a.gsi", first}, {"b.gsi", other}});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.problem().text(), HasSubstr("check each instrument by itself"));
  const auto both = readCheckFiles({{"a.gsi", first}, {"b.gsi", later}});
  ASSERT_TRUE(both) << both.problem().text();
  EXPECT_THAT(both->remarks, testing::Contains(HasSubstr("the check takes the day of an earlier file")));
}

TEST(CheckFiles, FindTheUnitByWhatBothFacesAddUpTo) {
  const auto firstOf = [](const std::string& vertical, const std::string& back) {
    const auto readings = readOf("target,hz,v\nA,10.2030," + vertical + "\nA,190.2030," + back + "\n");
    return readings ? readings->readings[0].vertical.degrees() : -1;
  };
  EXPECT_NEAR(firstOf("88.1234", "311.8770"), 88.1234 * 0.9, 1e-9);
  EXPECT_NEAR(firstOf("88.1649", "271.4311"), 88 + 16 / 60.0 + 49 / 3600.0, 1e-9);
  EXPECT_NEAR(firstOf("88.6670", "271.3335"), 88.6670, 1e-9);
  EXPECT_THAT(problemOf("target,hz,v\nA,10.2030,88.1\nB,12.1,91.4\n"),
              HasSubstr("no single unit lets both faces"));
  const auto stated = readOf("target,hz,v\nA,10.2030,88.1\n", {.unit = AngleUnit::Degrees});
  ASSERT_TRUE(stated);
  EXPECT_NEAR(stated->readings[0].vertical.degrees(), 88.1, 1e-12);
}

TEST(CheckFiles, ReadRadiansAndFacesThatCountFromZero) {
  const auto readings =
      readOf("point,face,hz_rad,v_rad\nA,0,0.5,1.5\nA,1,3.641592653589793,4.783185307179586\n");
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_EQ(readings->readings[0].face, 1);
  EXPECT_EQ(readings->readings[1].face, 2);
  EXPECT_THAT(readings->remarks, testing::IsEmpty());
  EXPECT_NEAR(readings->readings[0].horizontal.radians(), 0.5, 1e-12);
}

TEST(CheckFiles, FollowTheCircleWhereTheFaceSaysOtherwise) {
  const auto readings = readOf("target,face,hz,v\nA,2,10°,80°\nA,1,190°,280°\n");
  ASSERT_TRUE(readings);
  EXPECT_EQ(readings->readings[0].face, 1);
  EXPECT_THAT(readings->remarks, ElementsAre(HasSubstr("whose stated face contradicts")));
}

TEST(CheckFiles, KnowElevations) {
  const auto readings = readOf("target,hz,v\nA,10°,5°\nA,190°,175°\nB,20°,-3°\nB,200°,183°\n");
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_EQ(readings->circle, VerticalCircle::Elevation);
  const auto rounds = completeRounds(*readings);
  EXPECT_NEAR(rounds[0].rounds[0].pairs[1].elevation.degrees(), -3, 1e-9);
}

TEST(CheckFiles, ReduceHorizontalDistancesToTheLineOfSight) {
  const auto readings = readOf("target,hz,v,hd_mm\nA,10°,60°,1000\n");
  ASSERT_TRUE(readings);
  EXPECT_NEAR(readings->readings[0].distanceM, 1 / std::sin(3.14159265358979 / 3), 1e-12);
}

TEST(CheckFiles, TakeSeriesForStationsWhereThereAreSetsBesides) {
  const auto readings = readOf("series,set,target,hz,v\n1,1,A,10°,80°\n1,1,A,190°,280°\n2,1,A,10°,80°\n");
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_THAT(readings->stations, ElementsAre("hall", "1", "2"));
}

TEST(CheckFiles, RefuseInOneSentence) {
  EXPECT_THAT(problemOf("target,hz,v\nA,10°,88°71'\n"), HasSubstr("line 2, column 7"));
  EXPECT_THAT(problemOf("target,hz,v\n,10°,88°\n"), HasSubstr("has no target"));
  EXPECT_THAT(problemOf("target,hz,v,distance\nA,10°,88°,far\n"), HasSubstr("is no distance"));
  EXPECT_THAT(problemOf("target,hz\nA,10°\n"), HasSubstr("vertical"));
  EXPECT_THAT(problemOf("target,hz,v\nA,10°,88°\nA,500gon,88°\n"), HasSubstr("line 3"));
  EXPECT_THAT(problemOf("{}"), HasSubstr("JSON"));
  EXPECT_FALSE(problemOf("").empty());
}

TEST(CheckFiles, RefuseMoreRowsThanAreWorkedOn) {
  std::string text = "target,hz,v\n";
  text.reserve(limits::mostRows * 9);
  for (std::size_t i = 0; i <= limits::mostRows + 1; ++i) text += "A,1°,88°\n";
  EXPECT_THAT(problemOf(text), HasSubstr(limits::asCount(limits::mostRows)));
}

}  // namespace
}  // namespace alidade::test
