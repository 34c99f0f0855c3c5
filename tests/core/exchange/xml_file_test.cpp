#include "core/exchange/xml_file.h"

#include <gmock/gmock.h>

#include "core/exchange/jobxml_reader.h"

namespace alidade::test {
namespace {

using ::testing::Eq;
using ::testing::IsEmpty;
using ::testing::Optional;

TEST(PlainXmlNumber, KeepsEveryDigit) {
  EXPECT_THAT(plainXmlNumber("223.05664937315"), Optional(Eq("223.05664937315")));
  EXPECT_THAT(plainXmlNumber("+10.50"), Optional(Eq("10.50")));
  EXPECT_THAT(plainXmlNumber("90"), Optional(Eq("90")));
  EXPECT_THAT(plainXmlNumber("90."), Optional(Eq("90")));
  EXPECT_THAT(plainXmlNumber(".5"), Optional(Eq("0.5")));
  EXPECT_THAT(plainXmlNumber("-0.25"), Optional(Eq("-0.25")));
  EXPECT_THAT(plainXmlNumber("4.5e-05"), Optional(Eq("0.000045")));
  EXPECT_THAT(plainXmlNumber("1.2345E2"), Optional(Eq("123.45")));
  EXPECT_THAT(plainXmlNumber("1.5e+2"), Optional(Eq("150")));
  for (const char* text : {"", "-", ".", "1,5", "1e", "1e99", "INF", "NaN", "1.2.3", "0x10", "1 2"})
    EXPECT_EQ(plainXmlNumber(text), std::nullopt) << text;
  EXPECT_EQ(plainXmlNumber(std::string(60, '1')), std::nullopt);
}

TEST(DateOfTime, TakesTheDay) {
  EXPECT_EQ(dateOfTime("2025-04-22T15:02:35"), "2025-04-22");
  EXPECT_THAT(dateOfTime("22.04.2025"), IsEmpty());
  EXPECT_THAT(dateOfTime(""), IsEmpty());
}

TEST(XmlFile, ExpandsNoEntities) {
  const std::string bomb =
      "<!DOCTYPE JOBFile [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">]>\n"
      "<JOBFile><FieldBook><PointRecord><Name>&b;</Name><Circle><HorizontalCircle>10</HorizontalCircle>"
      "<VerticalCircle>90</VerticalCircle></Circle></PointRecord></FieldBook></JOBFile>";
  EXPECT_TRUE(looksLikeJobXml(bomb));
  const Recording recording = readJobXml(bomb);
  ASSERT_EQ(recording.sightings.size(), 1u);
  EXPECT_EQ(recording.sightings[0].row.point, "&b;");
  EXPECT_EQ(recording.sightings[0].line, 2u);
}

TEST(XmlFile, StandsAMillionLevels) {
  std::string deep = "<JOBFile><FieldBook>";
  for (int level = 0; level < 1'000'000; ++level) deep += "<a>";
  EXPECT_FALSE(readJobXml(deep).problems.empty());
}

TEST(XmlFile, RefusesMoreElementsThanAreRead) {
  std::string many = "<JOBFile><FieldBook>";
  many.reserve(40'000'000);
  for (int i = 0; i < 8'000'001; ++i) many += "<a/>";
  const Recording recording = readJobXml(many + "</FieldBook></JOBFile>");
  ASSERT_EQ(recording.problems.size(), 1u);
  EXPECT_THAT(recording.problems[0].what, ::testing::HasSubstr("more than 8,000,000 elements"));
}

}  // namespace
}  // namespace alidade::test
