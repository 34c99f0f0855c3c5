#include "core/session/protocol_progress.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/session/sighting_order.h"

namespace alidade {
namespace {

/// "0: z1 z2 1.1.1 1.1.2 | 180: …", point.round.face; zeros after the readings as Z.
std::string shortText(const PlannedSighting& planned) {
  if (planned.isZero) return (planned.isAfter ? "Z" : "z") + std::to_string(planned.face);
  return std::to_string(planned.point) + "." + std::to_string(planned.round) + "." +
         std::to_string(planned.face);
}

std::string orderOf(const SightingProtocol& protocol) {
  EXPECT_EQ(sightingCount(protocol), sightingsInOrder(protocol).size());
  std::string text;
  std::size_t position = protocol.positions.size();
  for (const PlannedSighting& planned : sightingsInOrder(protocol)) {
    if (planned.protocolPosition != position)
      text += (text.empty() ? "" : "| ") + std::to_string(planned.axisDeg) + ": ";
    position = planned.protocolPosition;
    text += shortText(planned) + " ";
  }
  return text;
}

SightingProtocol threePlaces(std::vector<ProtocolRound> rounds) {
  SightingProtocol protocol;
  for (const int point : {1, 2, 3}) protocol.places.push_back({.point = point});
  protocol.positions = {{.axisDeg = 0, .rounds = rounds}, {.axisDeg = 180, .rounds = rounds}};
  return protocol;
}

TEST(SightingsInOrder, GoThereAndBack) {
  EXPECT_EQ(orderOf(threePlaces({{false, {1}}, {true, {1}}})),
            "0: z1 1.1.1 2.1.1 3.1.1 3.2.1 2.2.1 1.2.1 | 180: z1 1.1.1 2.1.1 3.1.1 3.2.1 2.2.1 1.2.1 ");
}

TEST(SightingsInOrder, ReadBothFacesWhereTheSliderStands) {
  EXPECT_EQ(orderOf(threePlaces({{false, {2, 1}}})),
            "0: z1 1.1.2 1.1.1 2.1.2 2.1.1 3.1.2 3.1.1 | 180: z1 1.1.2 1.1.1 2.1.2 2.1.1 3.1.2 3.1.1 ");
}

/// Rows as "point.round.face" of either position.
Session sessionOf(const SightingProtocol& protocol, const std::vector<std::string>& at0,
                  const std::vector<std::string>& at180) {
  Session session;
  session.protocol = protocolText(protocol);
  for (const auto& [axis, rows] : {std::pair("0", at0), std::pair("180", at180)}) {
    Position position{.axisDeg = axis, .zero = {}, .readings = {}, .origin = {}};
    for (const std::string& keys : rows) {
      Reading row;
      std::istringstream in(keys);
      std::getline(in, row.point, '.');
      std::getline(in, row.round, '.');
      std::getline(in, row.face, '.');
      row.horizontal = row.vertical = "90";
      position.readings.push_back(row);
    }
    session.positions.push_back(position);
  }
  return session;
}

bool isFollowed(const SightingProtocol& protocol, const std::vector<std::string>& at0,
                const std::vector<std::string>& at180) {
  const auto own = protocolOf(sessionOf(protocol, at0, at180));
  EXPECT_TRUE(own);
  return own && *own;
}

TEST(YieldingProtocol, IsFollowedAsLongAsTheRowsStandInItsOrder) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.isYielding = true;
  EXPECT_TRUE(isFollowed(protocol, {}, {}));
  EXPECT_TRUE(isFollowed(protocol, {"1", "2"}, {}));
  EXPECT_TRUE(isFollowed(protocol, {"1", "", "3.1.1"}, {"1.1"}));
  EXPECT_TRUE(isFollowed(protocol, {"1", "2", "3"}, {"1", "2", "3"}));
  const std::vector<std::vector<std::string>> others[] = {
      {{"2"}, {}},                   // begins elsewhere
      {{"1.1.2"}, {}},               // in the other face
      {{"1", "1.1.2"}, {}},          // both faces
      {{"1", "2", "2.2"}, {}},       // a way back from fewer places
      {{"1", "2", "3", "4"}, {}},    // more places
      {{"1", "2", "3", "1.2"}, {}},  // another round
      {{"1", "2"}, {"1"}},           // fewer places
      {{"1", "2", "3"}, {"3"}},      // the other way at 180°
      {{}, {"1"}},                   // 180° first
      {{"1", "x", "3"}, {}},         // what is no number
  };
  for (const auto& rows : others) EXPECT_FALSE(isFollowed(protocol, rows[0], rows[1])) << rows[0].size();
  protocol.isYielding = false;
  for (const auto& rows : others) EXPECT_TRUE(isFollowed(protocol, rows[0], rows[1]));
}

TEST(YieldingProtocol, LeavesTheNextRowToTheRowsAbove) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.isYielding = true;
  EXPECT_EQ(followingReading(sessionOf(protocol, {"1", "2"}, {}), 0).point, "3");
  const Reading paired = followingReading(sessionOf(protocol, {"1.1.1", "1.1.2"}, {}), 0);
  EXPECT_EQ(paired.point + paired.face, "21");
  EXPECT_EQ(followingReading(sessionOf(protocol, {"5", "4"}, {}), 0).point, "3");
  EXPECT_EQ(followingReading(sessionOf(protocol, {"1", "2", "3", "4"}, {}), 0).point, "5");
}

TEST(YieldingProtocol, IsKeptAndSaysSo) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.isYielding = true;
  EXPECT_TRUE(readProtocol(writeProtocol(protocol))->isYielding);
  EXPECT_FALSE(readProtocol(writeProtocol(threePlaces({{}})))->isYielding);
  EXPECT_EQ(writeProtocol(threePlaces({{}})).find("yields"), std::string::npos);
}

TEST(ProtocolByWorth, IsLedByTheSightingChosenAndPassesNoneOver) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.isByWorth = true;
  Session session;
  session.positions = {{.axisDeg = "0", .zero = {}, .readings = {}, .origin = {}},
                       {.axisDeg = "180", .zero = {}, .readings = {}, .origin = {}}};
  PointingZero& zero = session.positions[0].zero;
  zero.horizontal = zero.vertical = "90";
  const auto row = [](const char* point) {
    Reading reading;
    reading.point = point;
    reading.horizontal = reading.vertical = "90";
    return reading;
  };
  session.positions[0].readings = {row("3"), row("1")};
  constexpr std::size_t second = 2, turned = 4;
  const ProtocolProgress progress = progressOf(session, protocol, second);
  EXPECT_EQ(progress.next, second);
  EXPECT_EQ(progress.missed + progress.outOfTurn, 0u);
  EXPECT_EQ(followingReading(session, 0, second).point, "2");
  EXPECT_EQ(progressOf(session, protocol, turned).next, turned);
  session.positions[0].readings.push_back(row("2"));
  EXPECT_NE(progressOf(session, protocol, second).next, second) << "it is there now";
  zero = {};
  EXPECT_EQ(progressOf(session, protocol, turned).next, 0u) << "the zero is missing";
  zero.horizontal = zero.vertical = "90";
  session.positions[0].readings.pop_back();
  protocol.isByWorth = false;
  EXPECT_EQ(progressOf(session, protocol, turned).next, second) << "in its order";
}

TEST(SightingsInOrder, TurnTheTelescopeOverOnceAtEachPlace) {
  EXPECT_EQ(orderOf(threePlaces({{false, {1, 2, 2, 1}}, {true, {2}}})).substr(0, 63),
            "0: z1 1.1.1 1.1.2 2.1.2 2.1.1 3.1.1 3.1.2 3.2.2 2.2.2 1.2.2 | 1");
}

TEST(SightingsInOrder, SightTheZerosBeforeAndAfterInTheirFaces) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.positions[0].zeros = {{2, 1}, {1, 2}};
  protocol.positions.pop_back();
  EXPECT_EQ(orderOf(protocol), "0: z2 z1 1.1.1 2.1.1 3.1.1 Z1 Z2 ");
}

TEST(SightingsInOrder, CountAPositionMeasuredAgainAndOneWithPlacesOfItsOwn) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.positions.push_back({.axisDeg = 0, .places = {{.point = 9}}});
  EXPECT_EQ(orderOf(protocol), "0: z1 1.1.1 2.1.1 3.1.1 | 180: z1 1.1.1 2.1.1 3.1.1 | 0: z1 9.1.1 ");
  EXPECT_EQ(sightingsInOrder(protocol).back().repeat, 2);
}

TEST(SightingsInOrder, AreThoseOfTwentyFourPlaces) {
  SightingProtocol protocol;
  for (int point = 1; point <= 24; ++point) protocol.places.push_back({.point = point});
  protocol.positions = {{.axisDeg = 180, .rounds = {{false, {1, 2}}, {true, {1, 2}}}}};
  const auto sightings = sightingsInOrder(protocol);
  ASSERT_EQ(sightings.size(), 1u + 24 * 2 * 2);
  EXPECT_EQ(shortText(sightings[48]), "24.1.2");
  EXPECT_EQ(shortText(sightings[49]), "24.2.1");
  EXPECT_EQ(shortText(sightings.back()), "1.2.2");
}

/// A session with the given readings: "z1" a zero, else point.round.face, with x if it is excluded.
class Led {
 public:
  explicit Led(SightingProtocol protocol) : m_protocol(std::move(protocol)), m_session(blankSession()) {
    m_session.protocol = protocolText(m_protocol);
  }

  Led& zero(std::size_t position) {
    m_session.positions[position].zero.horizontal = m_session.positions[position].zero.vertical = "1 2 3";
    return *this;
  }
  Led& row(std::size_t position, int point, int round = 1, int face = 1, bool excluded = false) {
    Reading row;
    row.point = std::to_string(point);
    row.round = std::to_string(round);
    row.face = std::to_string(face);
    row.horizontal = row.vertical = "1 2 3";
    row.excluded = excluded;
    m_session.positions[position].readings.push_back(row);
    return *this;
  }

  ProtocolProgress progress() const { return progressOf(m_session, m_protocol); }
  std::string next() const {
    const ProtocolProgress progress = *progressIn(m_session);
    if (!progress.next) return "none";
    const PlannedSighting& planned = progress.sightings[*progress.next].planned;
    return std::to_string(planned.axisDeg) + ":" + shortText(planned);
  }
  Session& session() { return m_session; }

 private:
  SightingProtocol m_protocol;
  Session m_session;
};

TEST(ProtocolProgress, LeadsFromTheZeroThroughTheRoundsToTheOtherPosition) {
  Led led(threePlaces({{false, {1}}, {true, {1}}}));
  EXPECT_EQ(led.next(), "0:z1");
  EXPECT_EQ(led.zero(0).next(), "0:1.1.1");
  EXPECT_EQ(led.row(0, 1).next(), "0:2.1.1");
  led.row(0, 2).row(0, 3);
  EXPECT_EQ(led.next(), "0:3.2.1");
  led.row(0, 3, 2).row(0, 2, 2).row(0, 1, 2);
  EXPECT_EQ(led.next(), "180:z1");
  EXPECT_EQ(led.zero(1).next(), "180:1.1.1");
  led.row(1, 1).row(1, 2).row(1, 3).row(1, 3, 2).row(1, 2, 2).row(1, 1, 2);
  EXPECT_EQ(led.next(), "none");
  EXPECT_TRUE(led.progress().isComplete());
  EXPECT_EQ(led.progress().taken, 14u);
}

TEST(ProtocolProgress, GoesOnFromWhereTheReadingsAreAndComesBackToWhatWasPassedOver) {
  Led led(threePlaces({{false, {1}}, {true, {1}}}));
  led.zero(0).row(0, 1).row(0, 3);
  EXPECT_EQ(led.next(), "0:3.2.1");
  EXPECT_EQ(led.progress().missed, 1u);
  EXPECT_EQ(led.progress().sightings[2].state, SightingState::Missed);
  led.row(0, 3, 2).row(0, 2, 2).row(0, 1, 2);
  EXPECT_EQ(led.next(), "0:2.1.1");
  led.row(0, 2);
  EXPECT_EQ(led.progress().outOfTurn, 1u);
  EXPECT_TRUE(led.progress().sightings[2].isOutOfTurn);
  EXPECT_EQ(led.next(), "180:z1");
}

TEST(ProtocolProgress, CountsExcludedOnesAndWhatIsBesideTheProtocol) {
  Led led(threePlaces({{}}));
  led.zero(0).row(0, 1, 1, 1, true).row(0, 2).row(0, 2, 1, 2).row(0, 7);
  const ProtocolProgress progress = led.progress();
  EXPECT_EQ(progress.excluded, 1u);
  EXPECT_EQ(progress.unplanned, 2u) << "point 2 in face 2, and point 7";
  EXPECT_EQ(progress.taken, 2u) << "the zero and point 2";
  EXPECT_EQ(progress.left(), 5u);
  led.row(0, 1);
  EXPECT_EQ(led.progress().excluded, 0u) << "taken again";
  EXPECT_EQ(led.progress().taken, 3u);
}

TEST(ProtocolProgress, WantsTheZerosBehindTheReadingsLast) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.positions[0].zeros = {{1, 2}, {1, 2}};
  Led led(protocol);
  EXPECT_EQ(led.zero(0).next(), "0:z2");
  led.session().positions[0].zero.faceTwo = {"1 2 3", "1 2 3"};
  EXPECT_EQ(led.next(), "0:1.1.1");
  led.row(0, 1).row(0, 3);
  EXPECT_EQ(led.next(), "0:2.1.1") << "passed over, and before the zeros";
  led.row(0, 2);
  EXPECT_EQ(led.next(), "0:Z1");
  led.session().positions[0].zero.after = {"1 2 3", "1 2 3"};
  EXPECT_EQ(led.next(), "0:Z2");
  EXPECT_EQ(zeroField(led.progress().sightings.back().planned), "pointing_zero");
}

TEST(ProtocolProgress, TakesAHalfTypedRowForOneToCome) {
  Led led(threePlaces({{}}));
  led.zero(0).row(0, 1).row(0, 2);
  led.session().positions[0].readings.back().vertical.clear();
  EXPECT_EQ(led.next(), "0:2.1.1");
  EXPECT_EQ(led.progress().sightings[2].row, 1u);
}

TEST(ProtocolProgress, SaysWhichPositionsTheSessionLacks) {
  SightingProtocol protocol = threePlaces({{}});
  protocol.positions.push_back({.axisDeg = 0});
  Session session = blankSession();
  EXPECT_EQ(positionsLacking(session, protocol), std::vector<int>{0});
  session.positions.erase(session.positions.begin());
  EXPECT_EQ(positionsLacking(session, protocol), (std::vector<int>{0, 0}));
}

TEST(FollowingReading, IsThatOfTheProtocolUntilAllOfItIsThere) {
  Led led(threePlaces({{false, {1, 2, 2, 1}}}));
  std::string order;
  for (int i = 0; i < 6; ++i) {
    Reading row = followingReading(led.session(), 1);
    order += row.point + "/" + (row.face.empty() ? "1" : row.face) + " ";
    row.horizontal = row.vertical = "1 2 3";
    led.session().positions[1].readings.push_back(row);
  }
  EXPECT_EQ(order, "1/1 1/2 2/2 2/1 3/1 3/2 ");
  EXPECT_EQ(followingReading(led.session(), 1).point, "4") << "as it would be without one";
}

}  // namespace
}  // namespace alidade
