#include "core/series/instrument_check/instrument_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/series/instrument_check/check_findings.h"
#include "core/series/instrument_check/instrument_json.h"
#include "tests/core/series/instrument_check/simulated_rounds.h"

namespace alidade::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

const std::vector<Target> around{{10, 3, 40}, {95, -4, 25}, {200, 12, 60}, {290, 1, 33}};

StationRounds station(const std::string& name, const SimulatedInstrument& instrument, int rounds,
                      std::uint64_t seed) {
  StationRounds made = completeRounds(simulatedRounds(instrument, around, rounds, seed)).front();
  made.station = name;
  return made;
}

std::string sentences(const InstrumentCheck& check) {
  std::string all;
  for (const Finding& finding : checkFindings(check)) all += finding.text + " " + finding.remedy + "\n";
  return all;
}

TEST(InstrumentCheck, PoolsByDegreesOfFreedom) {
  const InstrumentCheck check =
      checkInstrument({station("P", {.noise = 1}, 3, 1), station("Q", {.noise = 1}, 7, 2)});
  const StationCheck &p = check.stations[0], &q = check.stations[1];
  EXPECT_EQ(check.direction.degreesOfFreedom, 6 + 18);
  EXPECT_EQ(check.vertical.degreesOfFreedom, 8 + 24);
  EXPECT_NEAR(
      check.direction.s(),
      std::sqrt((6 * p.direction.s() * p.direction.s() + 18 * q.direction.s() * q.direction.s()) / 24),
      1e-12);
  // All stations have one geometry, so the numbers of rounds are the weights. Only the elevations as read
  // differ slightly: 1e-4 of differences of 1″.
  EXPECT_NEAR(check.collimation.value, (12 * p.collimation.value + 28 * q.collimation.value) / 40, 1e-4);
  EXPECT_NEAR(check.index.value, (12 * p.index.value + 28 * q.index.value) / 40, 1e-12);
}

// A station whose targets are all at one elevation takes the trunnion tilt for collimation: i tan 30° = 35″.
// The stations that state the tilt give the collimation, within 4 u.
TEST(InstrumentCheck, PoolsTheCollimationOfStationsThatStateTheTilt) {
  const SimulatedInstrument tilted{.collimation = 5, .tilt = 60, .noise = 1};
  const std::vector<Target> level{{10, 30, 40}, {95, 30.1, 25}, {200, 30, 60}, {290, 29.9, 33}};
  const std::vector<Target> spread{{10, 30, 40}, {95, -14, 25}, {200, 12, 60}, {290, 1, 33}};
  const auto station = [&](const char* name, const std::vector<Target>& targets, std::uint64_t seed) {
    StationRounds made = completeRounds(simulatedRounds(tilted, targets, 5, seed)).front();
    made.station = name;
    return made;
  };
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const InstrumentCheck check =
        checkInstrument({station("level", level, seed), station("spread", spread, seed + 10)});
    ASSERT_TRUE(check.tilt);
    EXPECT_NEAR(check.collimation.value, 5, 4 * check.collimation.u);
    EXPECT_LT(check.collimation.u, 1);
    EXPECT_NEAR(check.tilt->value, 60, 4 * check.tilt->u);
  }
}

TEST(InstrumentCheck, TestsAgainstAStatedSigma) {
  // χ²₀.₉₅(24) = 36.415 (any table): s up to σ √(36.415/24) = 1.2318 σ.
  const std::vector<StationRounds> rounds{station("P", {.noise = 1}, 9, 4)};
  const InstrumentCheck wide = checkInstrument(rounds, {.sigmaDirection = 2, .sigmaVertical = 2});
  ASSERT_TRUE(wide.directionTest);
  EXPECT_EQ(wide.direction.degreesOfFreedom, 24);
  EXPECT_NEAR(wide.directionTest->limit, 2 * 1.2318, 1e-3);
  EXPECT_TRUE(wide.directionTest->isWithin());
  EXPECT_THAT(sentences(wide), HasSubstr("is not significantly larger than the stated 2″"));
  const InstrumentCheck narrow = checkInstrument(rounds, {.sigmaDirection = 0.3});
  EXPECT_FALSE(narrow.directionTest->isWithin());
  EXPECT_FALSE(narrow.verticalTest);
  EXPECT_THAT(sentences(narrow), HasSubstr("is significantly larger than the stated 0.3″"));
}

TEST(InstrumentCheck, TellsSamplesOfTwoKindsApart) {
  const auto of = [](double noise) {
    return checkInstrument({station("P", {.noise = 1}, 7, 1), station("Q", {.noise = noise}, 7, 2)});
  };
  ASSERT_EQ(of(1).samples.size(), 1U);
  EXPECT_GT(of(1).samples[0].directionP, 0.05);
  EXPECT_LT(of(5).samples[0].directionP, 0.001);
  EXPECT_THAT(sentences(of(5)), HasSubstr("s of a direction is not the same at stations “P” and “Q”"));
  const InstrumentCheck three = checkInstrument(
      {station("P", {.noise = 1}, 7, 1), station("Q", {.noise = 1}, 7, 2), station("R", {.noise = 6}, 7, 3)});
  ASSERT_EQ(three.samples.size(), 3U);
  EXPECT_LT(three.samples[2].verticalP, 0.001);
}

/// F of 5 % on two sides at 18 and 18 degrees of freedom: chance alone reports one of twenty as different.
TEST(InstrumentCheck, SeldomTellsSamplesOfOneKindApart) {
  int alarms = 0;
  constexpr int draws = 1000;
  for (std::uint64_t seed = 0; seed < draws; ++seed)
    alarms += checkInstrument(
                  {station("P", {.noise = 1}, 7, 2 * seed), station("Q", {.noise = 1}, 7, 2 * seed + 1)})
                          .samples[0]
                          .directionP < 0.05
                  ? 1
                  : 0;
  EXPECT_NEAR(static_cast<double>(alarms) / draws, 0.05, 0.024);  // 3.5 σ of the binomial
}

TEST(InstrumentCheck, SaysWhatItFinds) {
  const InstrumentCheck tilted = checkInstrument({station("P", {.tilt = 60, .noise = 0.5}, 4, 1)});
  ASSERT_TRUE(tilted.tilt);
  EXPECT_NEAR(tilted.tilt->value, 60, 3 * tilted.tilt->u);
  EXPECT_THAT(sentences(tilted), HasSubstr("The trunnion axis is tilted by 59.30″ ± 0.81″"));
  EXPECT_THAT(sentences(checkInstrument({station("P", {.eccentricityMm = 1, .noise = 0.5}, 6, 1)})),
              HasSubstr("is proportional to 1/D"));
  EXPECT_THAT(sentences(checkInstrument({station("P", {.index = 30, .noise = 0.5}, 3, 1)})),
              HasSubstr("differs from zero by more than its scatter"));
  EXPECT_THAT(sentences(checkInstrument({station("P", {.noise = 0.5, .driftPerRound = 4}, 6, 1)})),
              HasSubstr("The orientation drifts by"));
  const std::vector<Target> near{{0, 0, 2.4}, {90, 0, 2.4}, {180, 0, 2.4}, {270, 0, 2.4}};
  const std::string flat =
      sentences(checkInstrument({completeRounds(simulatedRounds({.noise = 1}, near, 3, 1)).front()}));
  EXPECT_THAT(flat, HasSubstr("half a millimetre is 43.0″ at 2.4 m"));
  EXPECT_THAT(flat, HasSubstr("indistinguishable from collimation"));
  EXPECT_THAT(sentences(checkInstrument({station("P", {.noise = 1}, 1, 1)})),
              HasSubstr("Observe three rounds or more"));
  EXPECT_THAT(sentences(checkInstrument({station("P", {.collimation = 2, .noise = 0}, 3, 1)})),
              testing::Not(HasSubstr("nan")));
}

TEST(InstrumentCheck, WritesTheKeysOfTheContract) {
  const InstrumentCheck check = checkInstrument({station("P", {.collimation = 2, .noise = 1}, 7, 1)});
  const Json json = Json::parse(instrumentJson({}, check, checkFindings(check), {}));
  const Json& one = json["stations"][0];
  EXPECT_EQ(one["station"], "P");
  EXPECT_EQ(one["targets"], 4);
  EXPECT_EQ(one["rounds"], 7);
  EXPECT_EQ(one["dof_direction"], 18);
  EXPECT_EQ(one["dof_zenith"], 24);
  for (const char* key : {"s_direction_arcsec", "s_zenith_arcsec", "collimation_arcsec",
                          "u_collimation_arcsec", "index_arcsec", "u_index_arcsec"})
    EXPECT_TRUE(one[key].is_number()) << key;
  for (const char* key : {"s_direction_arcsec", "dof_direction", "s_zenith_arcsec", "dof_zenith"})
    EXPECT_EQ(json["pooled"][key], one[key]) << key;
  EXPECT_EQ(one["course"].size(), 7U);
  const InstrumentCheck single = checkInstrument({station("P", {.noise = 1}, 1, 1)});
  EXPECT_TRUE(Json::parse(instrumentJson({}, single, {}, {}))["pooled"]["s_direction_arcsec"].is_null());
}

TEST(InstrumentCheck, WritesATableOfEveryPair) {
  const std::string csv =
      instrumentCsv({"T", "1", "2026-03-14", ""}, checkInstrument({station("P", {.noise = 1}, 3, 1)}));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 12);
  EXPECT_THAT(csv, HasSubstr("station,round,target,direction_residual_arcsec"));
}

}  // namespace
}  // namespace alidade::test
