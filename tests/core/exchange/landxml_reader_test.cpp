#include "core/exchange/landxml_reader.h"

#include <gmock/gmock.h>

#include "tests/support/file_content.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A file with one observation, with the given attributes.
std::string landXmlOf(const std::string& units, const std::string& observation) {
  return "<LandXML version=\"1.2\">\n<Units><Metric linearUnit=\"millimeter\" " + units +
         "/></Units>\n<Survey><InstrumentSetup id=\"s\" stationName=\"K\"/><ObservationGroup setupID=\"s\">\n"
         "<RawObservation " +
         observation + "><TargetPoint name=\"1\"/></RawObservation></ObservationGroup></Survey></LandXML>";
}

std::vector<std::string> landXmlCircles(const std::string& unit, const std::string& horizontal,
                                        const std::string& zenith) {
  const Recording recording = readLandXml(landXmlOf(
      unit, "horizAngle=\"" + horizontal + "\" zenithAngle=\"" + zenith + "\" slopeDistance=\"2405\""));
  if (!recording.problems.empty()) return {recording.problems[0].text()};
  if (recording.sightings.empty()) return {};
  EXPECT_DOUBLE_EQ(recording.sightings[0].distanceM, 2.405);
  return {recording.sightings[0].row.horizontal, recording.sightings[0].row.vertical};
}

TEST(LandXml, ReadsRawObservationsDigitByDigit) {
  const Recording recording = readLandXml(contentOf(ALIDADE_REFERENCE_DIR "/import/read/captivate.xml"));
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 3u);
  const auto& one = recording.sightings[0];
  EXPECT_EQ(one.line, 11u);
  EXPECT_EQ(one.row.point, "1") << "pntRef leads to the CgPoint, which people call by its oID";
  EXPECT_EQ(one.row.face, "1");
  EXPECT_EQ(one.row.horizontal, "107 12 23.456");
  EXPECT_EQ(one.row.vertical, "88 47 31");
  EXPECT_EQ(one.distanceM, 2.405);
  EXPECT_EQ(recording.sightings[1].row.face, "2");
  EXPECT_EQ(recording.sightings[1].row.horizontal, "287 13 00") << "60 seconds are the next minute";
  EXPECT_EQ(recording.sightings[2].row.point, "2");
  EXPECT_EQ(recording.sightings[2].row.horizontal, "108 30 00");
  EXPECT_EQ(recording.instrumentName, "Leica TS60");
  EXPECT_EQ(recording.instrumentSerial, "885123");
  EXPECT_EQ(recording.measuredOn, "2024-03-05");
  EXPECT_THAT(recording.stations, ElementsAre("", "K1"));
  EXPECT_THAT(recording.unused, Contains("a deleted observation is not used: line 14"));
  EXPECT_THAT(recording.unused, Contains("a reduced observation, not a circle reading is not used: line 15"));
}

TEST(LandXml, HasNoZeroWhereItsSightingWasDeleted) {
  const auto observation = [](const char* attributes, const char* name) {
    return std::string("<RawObservation ") + attributes + " directFace=\"1\"><TargetPoint name=\"" + name +
           "\"/></RawObservation>";
  };
  const Recording recording = readLandXml(
      "<LandXML version=\"1.2\"><Units><Metric angularUnit=\"decimal degrees\" linearUnit=\"meter\"/></Units>"
      "<Survey><InstrumentSetup id=\"s\" stationName=\"K\"><FieldNote>ZERO</FieldNote>" +
      observation("unused=\"true\" horizAngle=\"100\" zenithAngle=\"90\"", "Z") +
      observation("horizAngle=\"107.5\" zenithAngle=\"88.5\"", "1") +
      "</InstrumentSetup></Survey></LandXML>");
  ASSERT_EQ(recording.sightings.size(), 1U);
  EXPECT_FALSE(recording.sightings[0].isZero);
}

TEST(LandXml, ReadsEveryUnitOfItsSchema) {
  EXPECT_THAT(landXmlCircles("angularUnit=\"grads\"", "107.1225", "98.473"),
              ElementsAre("107.1225gon", "98.473gon"));
  EXPECT_THAT(landXmlCircles("angularUnit=\"decimal degrees\"", "107.2065", "88.7921"),
              ElementsAre("107.2065°", "88.7921°"));
  EXPECT_THAT(landXmlCircles("angularUnit=\"decimal dd.mm.ss\"", "107.5960", "88.4731"),
              ElementsAre("108 00 00", "88 47 31"));
  // π/4 and π/2 to 16 digits: 45° and 90° to 1e-10°.
  EXPECT_THAT(landXmlCircles("angularUnit=\"radians\"", "0.785398163397448", "1.5707963267948966"),
              ElementsAre("45.0000000000°", "90.0000000000°"));
  EXPECT_THAT(landXmlCircles("", "0.785398163397448", "1.5707963267948966"),
              ElementsAre("45.0000000000°", "90.0000000000°"))
      << "radians are the schema's default";
}

TEST(LandXml, RefusesWhatItsUnitCannotBe) {
  EXPECT_THAT(landXmlCircles("", "107.1225", "98.473"),
              ElementsAre(HasSubstr("not circle readings in radians, the default unit of a LandXML file")));
  EXPECT_THAT(landXmlCircles("angularUnit=\"mil\"", "1", "2"),
              ElementsAre(HasSubstr("“mil” is no unit of angles")));
  EXPECT_THAT(landXmlCircles("angularUnit=\"decimal dd.mm.ss\"", "107.6123", "88.4731"),
              ElementsAre(HasSubstr("“107.6123” is no reading of a circle")));
  EXPECT_THAT(landXmlCircles("angularUnit=\"grads\"", "400.5", "98"),
              ElementsAre(HasSubstr("“400.5” is no reading")));
  const std::string reduced =
      landXmlOf("angularUnit=\"grads\"", "horizAngle=\"10\" zenithAngle=\"99\" directFace=\"0\"");
  ASSERT_EQ(readLandXml(reduced).problems.size(), 1u);
  EXPECT_THAT(readLandXml(reduced).problems[0].what, HasSubstr("is of face 2"));
}

TEST(LandXml, SaysWhereItHoldsNoRawObservations) {
  const Recording recording = readLandXml("<LandXML><CgPoints/></LandXML>");
  ASSERT_EQ(recording.problems.size(), 1u);
  EXPECT_THAT(recording.problems[0].what, HasSubstr("LandXML file holds no raw observations"));
}

}  // namespace
}  // namespace alidade::test
