#include "core/series/instrument_check/plausibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/series/instrument_check/check_findings.h"
#include "core/series/instrument_check/instrument_check.h"
#include "tests/core/series/instrument_check/simulated_rounds.h"

namespace alidade::test {
namespace {

using testing::HasSubstr;
using Change = std::function<void(FaceReading&)>;

const std::vector<Target> spread{{10, 3}, {95, -4}, {200, 12}, {290, 1}};

/// Rounds with the lines of a file whose first line is a heading.
CheckReadings plausible(int rounds, std::uint64_t seed = 1) {
  CheckReadings readings = simulatedRounds({.collimation = 5, .index = -3, .noise = 1}, spread, rounds, seed);
  for (std::size_t i = 0; i < readings.readings.size(); ++i) readings.readings[i].line = i + 2;
  return readings;
}

/// The readings `from` … `to` changed; a round of four targets has eight.
CheckReadings changed(std::size_t from, std::size_t to, const Change& change, int rounds = 3) {
  CheckReadings readings = plausible(rounds);
  for (std::size_t i = from; i <= to; ++i) change(readings.readings[i]);
  return readings;
}

std::string refusal(const CheckReadings& readings) {
  const Result<InstrumentCheck> check = checkReadings(readings);
  return check ? "" : check.problem().text();
}

Change turned(double arcseconds) {
  return [arcseconds](FaceReading& reading) {
    reading.horizontal = reading.horizontal + Angle::fromArcseconds(arcseconds);
  };
}

Change raised(double arcseconds) {
  return [arcseconds](FaceReading& reading) {
    reading.vertical = reading.vertical + Angle::fromArcseconds(arcseconds);
  };
}

TEST(Implausibility, LetsEveryInstrumentPass) {
  // A builder's vernier of 1′ has 17″; an electronic circle half an arcsecond. 200 draws of each.
  for (const double noise : {0.5, 17.0})
    for (std::uint64_t seed = 0; seed < 200; ++seed)
      ASSERT_EQ(refusal(simulatedRounds({.collimation = 30, .tilt = 40, .index = 300, .noise = noise}, spread,
                                        4, seed)),
                "")
          << seed;
}

TEST(Implausibility, NamesTheLinesOfATargetThatIsElsewhere) {
  // Target B in round 2: its face 1 is reading 9 of the file, line 11; its face 2 reading 14, line 16.
  CheckReadings readings = plausible(3);
  for (const std::size_t i : {9U, 14U}) turned(7200)(readings.readings[i]);
  EXPECT_THAT(refusal(readings),
              HasSubstr("lines 11 and 16: target “B” is 2.0° from where it was sighted in lines 3 and 8"));
}

TEST(Implausibility, NamesACircleThatCountsInTheOppositeDirection) {
  const CheckReadings readings = changed(16, 23, [](FaceReading& reading) {
    reading.horizontal = Angle::fromDegrees(360) - reading.horizontal;
  });
  EXPECT_THAT(refusal(readings), HasSubstr("the horizontal circle counts in the opposite direction"));
  EXPECT_THAT(refusal(readings), testing::StartsWith("lines 21 and 22: the horizontal circle"));
}

TEST(Implausibility, RefusesAnOrientationThatJumpsWithinARound) {
  EXPECT_THAT(refusal(changed(10, 15, turned(300))), HasSubstr("lines 1")) << "between two targets, by 5′";
  EXPECT_THAT(refusal(changed(12, 15, turned(300))), HasSubstr("the collimation of target"))
      << "between the faces, by 5′";
  EXPECT_EQ(refusal(changed(8, 15, turned(300))), "") << "between the rounds, where the circle may be set";
}

TEST(Implausibility, RefusesAMisreadMinute) {
  EXPECT_THAT(refusal(changed(9, 9, turned(600))), HasSubstr("lines 11 and 16: the direction of target “B”"));
  EXPECT_THAT(refusal(changed(9, 9, raised(600))),
              HasSubstr("lines 11 and 16: the zenith angle of target “B”"));
  EXPECT_THAT(refusal(changed(8, 15, raised(200))), HasSubstr("the index of target")) << "the index jumps";
}

TEST(Implausibility, RefusesAxesThatAreOffByDegrees) {
  EXPECT_THAT(refusal(simulatedRounds({.collimation = 2400, .noise = 1}, spread, 3, 1)),
              HasSubstr("collimation would be 40.0′, which no theodolite has"));
  EXPECT_THAT(refusal(simulatedRounds({.index = -2400, .noise = 1}, spread, 3, 1)),
              HasSubstr("index would be 40.0′"));
  EXPECT_THAT(refusal(simulatedRounds({.collimation = 7200, .noise = 1}, spread, 3, 1)),
              HasSubstr("differ by more than 2°"));
}

TEST(Implausibility, NamesTheFileAmongSeveral) {
  CheckReadings readings = changed(9, 9, turned(600));
  readings.files = {"north.gsi", "south.gsi"};
  for (FaceReading& reading : readings.readings) reading.file = 1;
  EXPECT_THAT(refusal(readings), testing::StartsWith("“south.gsi” lines 11"));
}

/// Returns consecutive rounds at several places of the instrument, under the name of one station.
CheckReadings atPlaces(const std::vector<int>& rounds) {
  CheckReadings all;
  for (std::size_t place = 0; place < rounds.size(); ++place) {
    std::vector<Target> targets = spread;
    for (std::size_t k = 0; k < targets.size(); ++k)
      targets[k].azimuthDeg += 7.0 * static_cast<double>(place * (k + 1));
    CheckReadings here =
        simulatedRounds({.collimation = 5, .index = -3, .noise = 1}, targets, rounds[place], place + 1);
    for (FaceReading& reading : here.readings)
      reading.line = all.readings.size() + 2, all.readings.push_back(reading);
    all.stations = here.stations;
    all.targets = here.targets;
  }
  return all;
}

TEST(PartedByGeometry, EvaluatesPlacesOfTheInstrumentOneByOne) {
  const Result<InstrumentCheck> check = checkReadings(atPlaces({3, 2, 4}));
  ASSERT_TRUE(check) << check.problem().text();
  ASSERT_EQ(check->stations.size(), 3U);
  EXPECT_EQ(check->stations[0].station, "S (1)");
  EXPECT_EQ(check->stations[2].rounds, 4U);
  EXPECT_EQ(check->direction.degreesOfFreedom, 6 + 3 + 9);
  // 1″ of a reading is 0.71″ of both faces. With 18 degrees of freedom it scatters by 17 %; the tolerance is
  // three times that.
  EXPECT_NEAR(check->direction.s(), 0.71, 0.36);
  const std::vector<Finding> findings = checkFindings(*check);
  EXPECT_TRUE(std::ranges::any_of(findings, [](const Finding& finding) {
    return finding.text.find("these rounds are evaluated as another station") != std::string::npos;
  }));
}

TEST(PartedByGeometry, IsRefusedWhereAPlaceHasOneRound) {
  EXPECT_THAT(refusal(atPlaces({3, 1})), HasSubstr("name the stations if the instrument was moved"));
}

TEST(PartedByGeometry, LeavesACircleThatIsSetAlone) {
  EXPECT_EQ(completeRounds(simulatedRounds({.noise = 1, .circleStepDeg = 61}, spread, 6, 1)).size(), 1U);
}

}  // namespace
}  // namespace alidade::test
