#include "core/series/instrument_check/rounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace alidade::test {
namespace {

/// Sightings as `A1 B1 B2 A2`: target and face; a word before a colon is the round stated in the file.
CheckReadings sighted(const std::string& order) {
  CheckReadings readings;
  readings.stations = {"S"};
  std::map<std::string, std::size_t> targets;
  std::istringstream words(order);
  double drift = 0;
  for (std::string word; words >> word; drift += 1) {
    FaceReading reading;
    if (const auto colon = word.find(':'); colon != std::string::npos) {
      reading.round = word.substr(0, colon);
      word = word.substr(colon + 1);
    }
    const auto [target, isNew] = targets.try_emplace(word.substr(0, 1), targets.size());
    if (isNew) readings.targets.push_back(target->first);
    reading.target = target->second;
    reading.face = word[1] - '0';
    const double alpha = 40.0 * static_cast<double>(target->second) + drift / 3600;
    reading.horizontal = Angle::fromDegrees(reading.face == 1 ? alpha : alpha + 180);
    reading.vertical = Angle::fromDegrees(reading.face == 1 ? 88 : 272);
    readings.readings.push_back(reading);
  }
  return readings;
}

StationRounds roundsOf(const std::string& order) {
  return completeRounds(sighted(order)).front();
}

std::size_t count(const StationRounds& station, LeftOut why) {
  return static_cast<std::size_t>(std::count_if(station.leftOut.begin(), station.leftOut.end(),
                                                [why](const auto& left) { return left.why == why; }));
}

TEST(CompleteRounds, FollowAnyOrder) {
  for (const char* order : {
           "A1 B1 C1 C2 B2 A2 A1 B1 C1 C2 B2 A2",  // there and back
           "A1 A2 B1 B2 C1 C2 A1 A2 B1 B2 C1 C2",  // each target in both faces
           "A1 B1 C1 C2 B2 A2 C2 B2 A2 A1 B1 C1",  // the second round begins in face 2
           "A1 B1 C1 A1 B1 C1 A2 B2 C2 A2 B2 C2",  // all of one face first
           "1:A1 1:A2 2:A1 2:A2 1:B1 1:B2 2:B1 2:B2 1:C1 1:C2 2:C1 2:C2",  // sorted by target
           "I:A1 I:B1 I:C1 I:C2 I:B2 I:A2 II:C2 II:B2 II:A2 II:A1 II:B1 II:C1",
       }) {
    const StationRounds station = roundsOf(order);
    EXPECT_EQ(station.targets.size(), 3U) << order;
    EXPECT_EQ(station.rounds.size(), 2U) << order;
    EXPECT_THAT(station.leftOut, testing::IsEmpty()) << order;
  }
}

TEST(CompleteRounds, AverageTheTargetThatClosesTheHorizon) {
  const StationRounds station = roundsOf("A1 B1 C1 A1 A2 C2 B2 A2 A1 B1 C1 A1 A2 C2 B2 A2");
  ASSERT_EQ(station.rounds.size(), 2U);
  EXPECT_EQ(count(station, LeftOut::Repeated), 4U);
  // The sightings are read 0″, 3″, 4″, 7″ and 8″, 11″, 12″, 15″ after the first one.
  EXPECT_NEAR(station.rounds[0].pairs[0].direction.arcseconds(), 3.5, 1e-6);
  EXPECT_NEAR(station.rounds[1].pairs[0].direction.arcseconds(), 11.5, 1e-6);
}

TEST(CompleteRounds, LeaveOutTheRoundThatLacksATarget) {
  const StationRounds station =
      roundsOf("A1 B1 C1 C2 B2 A2 A1 B1 C1 B2 A2 A1 B1 C1 C2 B2 A2 A1 B1 C1 C2 B2 A2");
  EXPECT_EQ(station.targets.size(), 3U);
  ASSERT_EQ(station.rounds.size(), 3U);
  EXPECT_EQ(station.rounds[1].name, "3");
  ASSERT_EQ(count(station, LeftOut::IncompleteRound), 1U);
  const auto& left = *std::find_if(station.leftOut.begin(), station.leftOut.end(),
                                   [](const auto& one) { return one.why == LeftOut::IncompleteRound; });
  EXPECT_EQ(left.round, "2");
  EXPECT_EQ(left.target, "C");
}

TEST(CompleteRounds, LeaveOutTheTargetThatMostRoundsLack) {
  const StationRounds station = roundsOf("A1 B1 X1 X2 B2 A2 A1 B1 B2 A2 A1 B1 B2 A2");
  EXPECT_THAT(station.targets, testing::ElementsAre("A", "B"));
  EXPECT_EQ(station.rounds.size(), 3U);
  EXPECT_EQ(count(station, LeftOut::RareTarget), 1U);
}

TEST(CompleteRounds, TakeARoundThatComesAgainForAFurtherOne) {
  const StationRounds station = roundsOf("1:A1 1:B1 1:B2 1:A2 2:A1 2:B1 2:B2 2:A2 1:A1 1:B1 1:B2 1:A2");
  ASSERT_EQ(station.rounds.size(), 3U);
  EXPECT_EQ(station.rounds[2].name, "1 (2)");
}

TEST(CompleteRounds, ReadAcrossTheZeroOfTheCircle) {
  CheckReadings readings = sighted("A1 B1 B2 A2");
  const auto set = [&](std::size_t i, double arcsec) {
    readings.readings[i].horizontal = Angle::fromDegrees(360) + Angle::fromArcseconds(arcsec);
  };
  readings.readings[0].horizontal = Angle::fromArcseconds(2);  // 0°00′02″
  readings.readings[3].horizontal = Angle::fromDegrees(180) - Angle::fromArcseconds(4);
  set(1, -6);
  readings.readings[2].horizontal = Angle::fromDegrees(180) + Angle::fromArcseconds(2);
  const StationRounds station = completeRounds(readings).front();
  EXPECT_NEAR(station.rounds[0].pairs[0].halfDirection.arcseconds(), 3, 1e-6);
  EXPECT_NEAR(wrapped(station.rounds[0].pairs[0].direction).arcseconds(), -1, 1e-6);
  EXPECT_NEAR(station.rounds[0].pairs[1].halfDirection.arcseconds(), -4, 1e-6);
}

TEST(CompleteRounds, LeaveOutFacesOfTwoTargets) {
  CheckReadings readings = sighted("A1 B1 B2 A2 A1 B1 B2 A2");
  readings.readings[2].horizontal = readings.readings[2].horizontal + Angle::fromDegrees(3);
  const StationRounds station = completeRounds(readings).front();
  EXPECT_EQ(count(station, LeftOut::FarApart), 1U);
  EXPECT_EQ(station.rounds.size(), 1U);
}

TEST(CompleteRounds, AreNoneInOneFace) {
  const StationRounds station = roundsOf("A1 B1 A1 B1");
  EXPECT_THAT(station.rounds, testing::IsEmpty());
  EXPECT_EQ(count(station, LeftOut::OneFace), 2U) << "nothing says that a second round began";
}

}  // namespace
}  // namespace alidade::test
