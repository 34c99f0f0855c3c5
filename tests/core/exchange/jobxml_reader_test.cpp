#include "core/exchange/jobxml_reader.h"

#include <gmock/gmock.h>

#include "core/series/instrument_check/check_files.h"
#include "core/series/instrument_check/instrument_check.h"
#include "core/series/instrument_check/rounds.h"
#include "tests/support/file_content.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string jobXmlOf(const std::string& records) {
  return "<?xml version=\"1.0\"?>\n<JOBFile version=\"5.72\"><FieldBook>\n" + records +
         "</FieldBook></JOBFile>\n";
}

std::string jobXmlPoint(const std::string& name, const std::string& horizontal, const std::string& vertical,
                        const std::string& face = "Face1", const std::string& more = "") {
  return "<PointRecord ID=\"9\"><Name>" + name + "</Name>" + more + "<Circle><HorizontalCircle>" +
         horizontal + "</HorizontalCircle><VerticalCircle>" + vertical +
         "</VerticalCircle><EDMDistance>2.4</EDMDistance><Face>" + face + "</Face></Circle></PointRecord>\n";
}

TEST(JobXml, ReadsTheFieldBookDigitByDigit) {
  const Recording recording = readJobXml(contentOf(ALIDADE_REFERENCE_DIR "/import/read/access.jxl"));
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 4u);
  const auto& zero = recording.sightings[0];
  EXPECT_TRUE(zero.isZero);
  EXPECT_EQ(zero.axis.text, "0");
  EXPECT_EQ(zero.row.horizontal, "0°") << "a full circle is the zero of the circle";
  EXPECT_EQ(zero.row.vertical, "90.000000000001°");
  const auto& second = recording.sightings[1];
  EXPECT_EQ(second.line, 24u);
  EXPECT_EQ(second.row.point, "1");
  EXPECT_EQ(second.row.face, "1");
  EXPECT_EQ(second.row.note, "SLIDER");
  EXPECT_EQ(second.row.horizontal, "9.05664937315°");
  EXPECT_EQ(second.row.vertical, "88.668194444444°");
  EXPECT_EQ(second.distanceM, 2.4051);
  EXPECT_EQ(recording.sightings[2].row.face, "2");
  EXPECT_EQ(recording.sightings[2].row.vertical, "271.3320°");
  EXPECT_EQ(recording.sightings[3].row.horizontal, "0.000045°");
  EXPECT_EQ(recording.sightings[3].row.face, "") << "FaceNull says nothing";
  EXPECT_EQ(recording.verticalCircle, "zenith");
  EXPECT_EQ(recording.instrumentName, "S7 1\"");
  EXPECT_EQ(recording.instrumentSerial, "37310042");
  EXPECT_EQ(recording.measuredOn, "2024-03-05");
  EXPECT_THAT(recording.stations, ElementsAre("", "K1"));
}

TEST(JobXml, TellsOfWhatIsNoReading) {
  const Recording recording = readJobXml(contentOf(ALIDADE_REFERENCE_DIR "/import/read/access.jxl"));
  EXPECT_THAT(recording.unused, Contains("a deleted observation is not used: line 39"));
  EXPECT_THAT(recording.unused, Contains("a mean of observations (MeanTurnedAngle) is not used: line 34"));
  EXPECT_THAT(readJobXml(jobXmlOf(jobXmlPoint("1", "10", "90") +
                                  jobXmlPoint("2", "11", "91", "Face1", "<Method>DistanceOffset</Method>")))
                  .unused,
              Contains(HasSubstr("no direct reading (“DistanceOffset”)")));
}

TEST(JobXml, RefusesReadingsOfACircleThatThereCannotBe) {
  const auto problemOf = [](const std::string& records) {
    const Recording recording = readJobXml(jobXmlOf(records));
    return recording.problems.empty() ? std::string() : recording.problems[0].text();
  };
  EXPECT_THAT(problemOf(jobXmlPoint("1", "361", "90")), HasSubstr("line 3: “361” is no reading of a circle"));
  EXPECT_THAT(problemOf(jobXmlPoint("1", "10", "INF")), HasSubstr("“INF” is no reading of a circle"));
  EXPECT_THAT(problemOf(jobXmlPoint("1", "-1", "90")), HasSubstr("“-1” is no reading"));
  EXPECT_THAT(problemOf(jobXmlPoint("1", "1e19", "90")), HasSubstr("is no reading"));
  EXPECT_THAT(problemOf(jobXmlPoint("1", "190", "88", "Face2")),
              HasSubstr("is of face 2, yet its vertical reading “88” is of the other face"));
  EXPECT_THAT(problemOf("<PointRecord><Name>1</Name></PointRecord>"),
              HasSubstr("Trimble JobXML file holds no"));
}

TEST(JobXml, IsRefusedWhereItIsBrokenOff) {
  const std::string whole = jobXmlOf(jobXmlPoint("1", "10", "90"));
  const Recording recording = readJobXml(whole.substr(0, whole.size() - 15));
  ASSERT_EQ(recording.problems.size(), 1u);
  EXPECT_THAT(recording.problems[0].what, HasSubstr("broken off"));
  EXPECT_EQ(recording.sightings.size(), 1u) << "what stands before the break tells whether the axis is named";
}

/// The second set-up on the same point has its circle turned: two stations.
TEST(JobXml, KeepsSetUpsApart) {
  const auto station = [](const std::string& id) {
    return "<StationRecord ID=\"" + id + "\"><StationName>K</StationName></StationRecord>\n";
  };
  const auto observed = [](const std::string& id, const std::string& horizontal) {
    return jobXmlPoint("P", horizontal, "90", "Face1", "<StationID>" + id + "</StationID>");
  };
  const Recording recording = readJobXml(jobXmlOf(station("a") + observed("a", "10") + station("b") +
                                                  observed("b", "70") + observed("a", "10")));
  EXPECT_THAT(recording.stations, ElementsAre("", "K", "K (2)"));
  ASSERT_EQ(recording.sightings.size(), 3u);
  EXPECT_EQ(recording.sightings[0].station, 1u);
  EXPECT_EQ(recording.sightings[1].station, 2u);
  EXPECT_EQ(recording.sightings[2].station, 1u);
}

/// Two targets in two rounds: face 2 reads 0.001° more, and the zeniths close to 0.002° beyond a turn.
TEST(JobXml, IsReadByTheInstrumentCheck) {
  std::string records = "<StationRecord ID=\"a\"><StationName>K1</StationName></StationRecord>\n";
  for (int round = 0; round < 2; ++round)
    records += jobXmlPoint("P", "10", "89") + jobXmlPoint("Q", "50", "91") +
               jobXmlPoint("Q", "230.001", "269.002", "Face2") +
               jobXmlPoint("P", "190.001", "271.002", "Face2");
  const auto readings = readCheckFiles({{"a.jxl", jobXmlOf(records)}});
  ASSERT_TRUE(readings) << readings.problem().text();
  EXPECT_THAT(readings->stations, Contains("K1"));
  const auto rounds = completeRounds(*readings);
  ASSERT_EQ(rounds.size(), 1u);
  // Half of the differences: face 1 reads 0.001° = 3.6″ less; the zeniths close to 0.002° = 7.2″ beyond 360°.
  EXPECT_NEAR(rounds[0].rounds[0].pairs[0].halfDirection.arcseconds(), -1.8, 1e-6);
  EXPECT_NEAR(rounds[0].rounds[0].pairs[0].halfVertical.arcseconds(), 3.6, 1e-6);
}

}  // namespace
}  // namespace alidade::test
