#include "core/session/protocol_progress.h"

#include <gtest/gtest.h>

#include "core/session/sighting_order.h"

namespace alidade {
namespace {

/// "0: z1 z2 1.1.1 1.1.2 | 180: …", point.round.face; zeros after the readings as Z.
std::string told(const PlannedSighting& planned) {
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
    text += told(planned) + " ";
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
  EXPECT_EQ(sightingsInOrder(protocol).back().time, 2);
}

TEST(SightingsInOrder, AreThoseOfTwentyFourPlaces) {
  SightingProtocol protocol;
  for (int point = 1; point <= 24; ++point) protocol.places.push_back({.point = point});
  protocol.positions = {{.axisDeg = 180, .rounds = {{false, {1, 2}}, {true, {1, 2}}}}};
  const auto sightings = sightingsInOrder(protocol);
  ASSERT_EQ(sightings.size(), 1u + 24 * 2 * 2);
  EXPECT_EQ(told(sightings[48]), "24.1.2");
  EXPECT_EQ(told(sightings[49]), "24.2.1");
  EXPECT_EQ(told(sightings.back()), "1.2.2");
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
    const auto next = nextSighting(m_session);
    return next ? std::to_string(next->planned.axisDeg) + ":" + told(next->planned) : "none";
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
  EXPECT_EQ(progress.beside, 2u) << "point 2 in face 2, and point 7";
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
