#include "core/wording/guidance.h"

#include <gtest/gtest.h>

#include "core/simulation/protocol.h"

namespace alidade {
namespace {

std::string namedInWords(const char* name) {
  return protocolInWords(*templateNamed(name));
}

TEST(ProtocolWords, SayWhatIsSighted) {
  EXPECT_EQ(namedInWords("paper"), "17 places, one face, there only");
  EXPECT_EQ(namedInWords("paper-slider"), "17 places, one face, there only, with slider readings");
  EXPECT_EQ(namedInWords("two-face"), "17 places, both faces, there and back");
  EXPECT_EQ(
      namedInWords("shifted-circle"),
      "17 places, both faces, there and back, with slider readings, the circle turned between positions");
  EXPECT_EQ(namedInWords("again"), "17 places, one face, there only, 0° again");
  EXPECT_EQ(protocolInWords(openOrder(*templateNamed("paper"))),
            "17 places, one face, there only, each sighting chosen by its information")
      << "without the positions that may be measured again";
}

TEST(ProtocolWords, SayWhatAProtocolOfOnesOwnSights) {
  SightingProtocol protocol;
  EXPECT_EQ(protocolInWords(protocol), "no places, one face, there only");
  protocol.places = {{.point = 1}};
  protocol.positions = {{.axisDeg = 180, .rounds = {{false, {1}}, {false, {2}}, {false, {1}}}}};
  EXPECT_EQ(protocolInWords(protocol), "1 place, one face per round, 3 rounds, only at 180°");
  protocol.positions.push_back({.axisDeg = 0, .places = {{.point = 1}, {.point = 2}}, .rounds = {{true}}});
  EXPECT_EQ(protocolInWords(protocol), "1 to 2 places, one face per round, up to 3 rounds");
}

class Deviations : public ::testing::Test {
 protected:
  Deviations() {
    protocol = *templateNamed("paper");
    session.positions = {{.axisDeg = "0", .zero = {}, .readings = {}, .origin = {}},
                         {.axisDeg = "180", .zero = {}, .readings = {}, .origin = {}}};
    for (Position& position : session.positions) position.zero.horizontal = position.zero.vertical = "90";
  }
  void read(int point, bool isExcluded = false) {
    Reading& row = session.positions[0].readings.emplace_back();
    row.point = std::to_string(point);
    row.horizontal = row.vertical = "90";
    row.excluded = isExcluded;
  }
  std::string sentences() const { return deviationSentences(progressOf(session, protocol)); }

  SightingProtocol protocol;
  Session session;
};

TEST_F(Deviations, AreNoneWhileTheOrderIsKept) {
  read(1);
  read(2);
  EXPECT_EQ(sentences(), "4 of 36 sightings are taken.");
}

TEST_F(Deviations, NameWhatWasPassedOverOutOfTurnAndTakenAgain) {
  read(1);
  read(4);
  read(3);
  read(4, true);
  EXPECT_EQ(
      sentences(),
      "5 of 36 sightings are taken. Skipped: 0°: point 2. Taken out of order: 0°: point 3. Taken again: "
      "0°: point 4.");
}

TEST_F(Deviations, CountTheSightingsBeyondSixAndThoseOfNoProtocol) {
  read(1);
  read(10);
  read(99);
  EXPECT_EQ(sentences(),
            "4 of 36 sightings are taken. Skipped: 0°: point 2; 0°: point 3; 0°: point 4; 0°: point 5; 0°: "
            "point 6; 0°: point 7 and 2 more. One reading is not in the protocol.");
}

TEST_F(Deviations, NameAnExcludedSighting) {
  read(1, true);
  EXPECT_EQ(sentences(), "2 of 36 sightings are taken. Excluded: 0°: point 1.");
}

}  // namespace
}  // namespace alidade
