#include "core/session/sighting_protocol.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/session/session_file.h"

namespace alidade {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json completeProtocol() {
  return Json::parse(R"({
    "format": "alidade-protocol", "version": 1, "name": "own", "description": "three places", "read_slider": true,
    "places": [{"point": 1, "slider": "20°", "arc": "20.5°"}, {"point": 2, "slider": "100gon"}, {"point": 5, "slider": "160°"}],
    "positions": [
      {"axis_deg": 0, "zeros": {"before": [1, 2], "after": [2, 1]},
       "rounds": [{"way": "there", "faces": [1, 2, 2, 1]}, {"way": "back", "faces": [2]}]},
      {"axis_deg": 180, "circle_turn": "90°", "zeros": {"before": [1]},
       "places": [{"point": 9}], "rounds": [{"way": "there", "faces": [1]}]}]})");
}

std::string sayingOfProtocol(const Json& json) {
  const Result<SightingProtocol> protocol = readProtocol(json.dump());
  return protocol ? "accepted" : protocol.problem().text();
}

std::string sayingOfProtocolWith(const char* pointer, const Json& value) {
  Json json = completeProtocol();
  json[Json::json_pointer(pointer)] = value;
  return sayingOfProtocol(json);
}

TEST(SightingProtocol, KeepsEveryTextAndNumber) {
  const SightingProtocol protocol = *readProtocol(completeProtocol().dump());
  EXPECT_EQ(protocol.name, "own");
  EXPECT_TRUE(protocol.readsSlider);
  EXPECT_EQ(protocol.places[0], (ProtocolPlace{1, "20°", "20.5°"}));
  EXPECT_EQ(protocol.places[2].point, 5);
  EXPECT_EQ(protocol.positions[0].zeros, (ProtocolZeros{{1, 2}, {2, 1}}));
  EXPECT_EQ(protocol.positions[0].rounds, (std::vector<ProtocolRound>{{false, {1, 2, 2, 1}}, {true, {2}}}));
  EXPECT_DOUBLE_EQ(circleTurn(protocol.positions[1]).degrees(), 90);
  EXPECT_DOUBLE_EQ(nominalPlace(protocol.places[0])->degrees(), 20.5)
      << "the arc angle before the coordinate";
  EXPECT_DOUBLE_EQ(nominalPlace(protocol.places[1])->degrees(), 90) << "100 gon";
  EXPECT_FALSE(nominalPlace(protocol.positions[1].places[0]));
  EXPECT_EQ(protocol.placesOf(protocol.positions[1]).size(), 1u);
}

TEST(SightingProtocol, MayBeByWorth) {
  Json json = completeProtocol();
  EXPECT_FALSE(readProtocol(json.dump())->isByWorth);
  json["order"] = "listed";
  EXPECT_FALSE(readProtocol(json.dump())->isByWorth);
  json["order"] = "by_worth";
  const SightingProtocol protocol = *readProtocol(json.dump());
  EXPECT_TRUE(protocol.isByWorth);
  EXPECT_EQ(Json::parse(writeProtocol(protocol)).at("order"), "by_worth");
  const SightingProtocol listed = *readProtocol(completeProtocol().dump());
  EXPECT_EQ(openOrder(listed).positions.size(), 2 * listed.positions.size());
  EXPECT_EQ(listedOrder(openOrder(listed)), listed);
  EXPECT_THAT(sayingOfProtocolWith("/order", "any"), HasSubstr("write listed or by_worth"));
}

TEST(SightingProtocol, HasMinutesOfItsOwn) {
  Json json = completeProtocol();
  EXPECT_EQ(readProtocol(json.dump())->minutes, SightingMinutes());
  json["minutes"] = {{"turning_axis", 12}, {"x-unknown", 3}};
  const SightingProtocol protocol = *readProtocol(json.dump());
  EXPECT_EQ(protocol.minutes.turningAxis, 12);
  EXPECT_EQ(protocol.minutes.drivingSlider, SightingMinutes().drivingSlider);
  EXPECT_EQ(Json::parse(writeProtocol(protocol)).at("minutes"), json.at("minutes"));
  EXPECT_THAT(sayingOfProtocolWith("/minutes/turning_axis", -1), HasSubstr("minutes.turning_axis: “-1” min"));
  EXPECT_THAT(sayingOfProtocolWith("/minutes/driving_slider", "long"), HasSubstr("minutes.driving_slider"));
}

TEST(SightingProtocol, LosesNothingOfUnknownKeysAtEveryLevel) {
  Json json = completeProtocol();
  for (const char* level : {"", "/places/1", "/positions/0", "/positions/0/zeros", "/positions/0/rounds/1",
                            "/positions/1/places/0"})
    json[Json::json_pointer(std::string(level) + "/x-unknown")] = {{"deep", {1, 2.5, nullptr}}};
  EXPECT_EQ(Json::parse(writeProtocol(*readProtocol(json.dump()))).dump(), json.dump());
}

TEST(SightingProtocol, TakesWhatIsLeftOutForTheUsual) {
  const SightingProtocol protocol = *readProtocol(
      R"({"format": "alidade-protocol", "version": 1, "places": [{}, {}], "positions": [{"axis_deg": 180}]})");
  EXPECT_EQ(protocol.places[1].point, 2);
  EXPECT_EQ(protocol.positions[0].zeros, ProtocolZeros{});
  EXPECT_EQ(protocol.positions[0].rounds, std::vector<ProtocolRound>{{}});
}

TEST(SightingProtocol, SaysWhatMeansNothingAndWhere) {
  EXPECT_EQ(sayingOfProtocol(completeProtocol()), "accepted");
  EXPECT_THAT(sayingOfProtocolWith("/format", "alidade-session"), HasSubstr("choose a measurement protocol"));
  EXPECT_THAT(sayingOfProtocolWith("/version", 2), HasSubstr("newer"));
  EXPECT_THAT(sayingOfProtocolWith("/positions", Json::array()), HasSubstr("positions: is empty"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/1/axis_deg", 90), HasSubstr("positions[1].axis_deg"));
  EXPECT_THAT(sayingOfProtocolWith("/places/1/point", 1), HasSubstr("places[1].point: 1 occurs twice"));
  EXPECT_THAT(sayingOfProtocolWith("/places/1/slider", "20.3"), HasSubstr("places[1].slider"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/zeros/before", {2}), HasSubstr("lacks face 1"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/zeros/after", {1, 1}), HasSubstr("names a face twice"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/rounds/0/way", "up"),
              HasSubstr("write \"there\" or \"back\""));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/rounds/0/faces", {1, 1}), HasSubstr("[1, 2, 2, 1]"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/rounds/0/faces", {3}), HasSubstr("other than a face"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/rounds", Json::array()), HasSubstr("rounds: is empty"));
  EXPECT_THAT(sayingOfProtocolWith("/positions/0/circle_turn", "400°"),
              HasSubstr("positions[0].circle_turn"));
  Json without = completeProtocol();
  without.erase("places");
  EXPECT_THAT(sayingOfProtocol(without), HasSubstr("positions[0].places: are missing"));
}

TEST(SightingProtocol, HoldsNoMoreThanAnybodySights) {
  Json json = completeProtocol();
  Json round = {{"way", "there"}, {"faces", {1}}}, rounds = Json::array();
  for (int i = 0; i < 4000; ++i) rounds.push_back(round);
  json["positions"][0]["rounds"] = rounds;
  EXPECT_THAT(sayingOfProtocol(json), HasSubstr("at most 10000"));
}

const char* const plainSession = R"({
  "format": "alidade-session",
  "version": 1,
  "geometry": {
    "distance_mm": 2405,
    "radius_mm": 400
  },
  "positions": []
}
)";

TEST(ProtocolOfSession, OfOldSessionsIsNoneAndLeavesNoTrace) {
  const Session session = *readSession(plainSession);
  EXPECT_FALSE(*protocolOf(session));
  EXPECT_EQ(writeSession(session), plainSession);
}

TEST(ProtocolOfSession, IsKeptInTheFileAsItWasWithUnknownKeys) {
  Json json = Json::parse(plainSession), protocol = completeProtocol();
  protocol["x-unknown"] = 1.5;
  json["protocol"] = protocol;
  const Session session = *readSession(json.dump());
  EXPECT_EQ(Json::parse(writeSession(session)).dump(), json.dump());
  EXPECT_EQ((*protocolOf(session))->name, "own");
}

TEST(ProtocolOfSession, GoesIntoASessionAndOut) {
  Session session = *readSession(plainSession);
  session.protocol = protocolText(*readProtocol(completeProtocol().dump()));
  const Session again = *readSession(writeSession(session));
  EXPECT_EQ(again, session);
  EXPECT_EQ(**protocolOf(again), *readProtocol(completeProtocol().dump()));
  Session without = again;
  without.protocol.clear();
  EXPECT_EQ(writeSession(without), plainSession);
}

TEST(ProtocolOfSession, ThatMeansNothingIsToldAndNotLost) {
  for (const Json& wrong : {Json("full"), Json(5), Json::array(), Json({{"positions", "none"}})}) {
    Json json = Json::parse(plainSession);
    json["protocol"] = wrong;
    const Session session = *readSession(json.dump());
    const auto protocol = protocolOf(session);
    ASSERT_FALSE(protocol) << wrong;
    EXPECT_THAT(protocol.problem().text(), HasSubstr("protocol")) << wrong;
    EXPECT_EQ(Json::parse(writeSession(session)).dump(), json.dump());
  }
}

}  // namespace
}  // namespace alidade
