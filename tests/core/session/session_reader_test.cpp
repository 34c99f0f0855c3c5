#include "core/session/session_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

Json rowOf(unsigned point) {
  return {{"point", point}, {"horizontal", std::to_string(point) + " 0 0"}, {"vertical", "90 0 0"}};
}

/// A document as the parser leaves it: its rows are passed on separately.
Json soundDocument() {
  return Json::parse(R"({
    "format": "alidade-session", "version": 1, "title": "t", "report": {"number": "1"}, "device": {"name": "d"},
    "instrument": {"sigma_zero_arcsec": 1}, "environment": {"temperature_c": 20},
    "geometry": {"distance_mm": 2405, "radius_mm": 400}, "acceptance": {"coverage": 0.9},
    "model": {"radius": "common", "effects": []},
    "positions": [
      {"axis_deg": 0, "pointing_zero": {"horizontal": "1 0 0", "vertical": "90 0 0"}, "readings": []},
      {"axis_deg": 180, "pointing_zero": {"horizontal": "2 0 0", "vertical": "90 0 1"}, "readings": []}]})");
}

TEST(SessionRows, ComeBackUnderTheirPositionInTheOrderRead) {
  SessionRows rows;
  for (const std::size_t position : {2u, 0u})
    for (const std::size_t reading : {0u, 1u, 2u})
      rows.add({.position = position, .reading = reading},
               rowOf(static_cast<unsigned>(10 * position + reading)));
  for (const std::size_t position : {0u, 2u}) {
    const RowsRead read = rows.take(position);
    EXPECT_FALSE(read.problem);
    ASSERT_EQ(read.readings.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read.readings[i].point, std::to_string(10 * position + i));
  }
  EXPECT_TRUE(rows.take(1).readings.empty());
  EXPECT_TRUE(rows.take(7).readings.empty());
}

TEST(SessionRows, KeepTheFirstThingWrongOfEachPosition) {
  SessionRows rows;
  rows.add({.position = 0, .reading = 0}, rowOf(1));
  rows.add({.position = 0, .reading = 1}, {{"point", true}, {"horizontal", 1}});
  rows.add({.position = 0, .reading = 2}, Json::array());
  rows.add({.position = 1, .reading = 0}, rowOf(1));
  EXPECT_EQ(rows.take(0).problem->where.path(), "positions[0].readings[1].point");
  EXPECT_FALSE(rows.take(1).problem);
}

// A hundred thousand rows that differ only in their texts.
TEST(SessionRows, ShareAnOriginWhereTheyDifferInTheirTextsOnly) {
  SessionRows rows;
  Json other = rowOf(3);
  other["weather"] = "sun";
  std::size_t next = 0;
  for (const Json& row : {rowOf(1), rowOf(2), other, rowOf(4)})
    rows.add({.position = 0, .reading = next++}, row);
  const std::vector<Reading> readings = rows.take(0).readings;
  const auto originOf = [&](std::size_t row) { return &readings[row].origin.object(); };
  EXPECT_EQ(originOf(0), originOf(1));
  EXPECT_NE(originOf(1), originOf(2));
  EXPECT_NE(originOf(2), originOf(3));
}

/// A row rebuilt from its origin, in which null replaces the texts. Empty texts are written only for the
/// circles.
Json madeAgain(const Reading& reading) {
  Json row = reading.origin.object();
  const auto put = [&](const char* key, const std::string& text, bool isNumber, bool isRequired = false) {
    if (!row.contains(key) || !row[key].is_null()) return;
    if (text.empty() && !isRequired)
      row.erase(key);
    else
      row[key] = isNumber ? Json(static_cast<unsigned>(std::stoul(text))) : Json(text);
  };
  put("point", reading.point, true);
  put("round", reading.round, true);
  put("face", reading.face, true);
  put("horizontal", reading.horizontal, false, true);
  put("vertical", reading.vertical, false, true);
  put("slider", reading.slider, false);
  put("note", reading.note, false);
  return row;
}

// For any preceding row, null in the file, 1.0, "1" and "" are not kept as texts of a row; 1 is.
TEST(SessionRows, LoseNothingWhateverTheRowBefore) {
  std::vector<Json> ways;
  for (const char* way :
       {R"({"point": 1, "round": 2, "face": 1, "horizontal": "1 2 3", "vertical": "90 0 0"})",
        R"({"point": 2, "round": 1, "face": 2, "horizontal": "", "vertical": "90 0 1"})",
        R"({"point": 2.0, "round": 1, "face": 2, "horizontal": "", "vertical": "90 0 1"})",
        R"({"point": "3", "round": 1, "face": 2, "horizontal": "1 2 3", "vertical": "90 0 1"})",
        R"({"point": -3, "round": 1, "face": 2, "horizontal": "1 2 3", "vertical": "90 0 1"})",
        R"({"round": 1, "point": 2, "face": 2, "horizontal": "1 2 4", "vertical": "90 0 1"})",
        R"({"point": 4, "horizontal": "1 2 3", "vertical": 90, "slider": ""})",
        R"({"point": 4, "horizontal": "1 2 3", "vertical": 90.0, "slider": ""})",
        R"({"point": 5, "horizontal": "1 2 4", "vertical": 90, "slider": "10"})",
        R"({"point": 6, "horizontal": "1 2 3", "vertical": "90 0 0", "note": "", "excluded": true})",
        R"({"point": 7, "horizontal": "1 2 3", "vertical": "90 0 0", "note": "n", "excluded": true})",
        R"({"point": 7, "horizontal": "1 2 3", "vertical": "90 0 0", "note": "n", "excluded": false})",
        R"({"point": 8, "horizontal": "1 2 3", "vertical": "90 0 0", "x": null})",
        R"({"point": 9, "horizontal": "1 2 3", "vertical": "90 0 0", "x": [1]})",
        R"({"point": 9, "horizontal": "1 2 3", "vertical": "90 0 0", "x": [1.0]})"})
    ways.push_back(Json::parse(way));
  std::mt19937 random(3);
  for (int order = 0; order < 100; ++order) {
    std::ranges::shuffle(ways, random);
    SessionRows rows;
    for (std::size_t i = 0; i < ways.size(); ++i) rows.add({.position = 0, .reading = i}, ways[i]);
    const RowsRead read = rows.take(0);
    ASSERT_FALSE(read.problem) << read.problem->text();
    for (std::size_t i = 0; i < ways.size(); ++i)
      EXPECT_EQ(madeAgain(read.readings[i]).dump(), ways[i].dump());
  }
}

// The document is damaged step by step, from its end to its beginning. Each time the problem is the damage
// nearest to the beginning.
TEST(SessionFromJson, NamesTheFirstThingWrong) {
  Json json = soundDocument();
  SessionRows sound, wrong;
  for (const std::size_t position : {0u, 1u}) {
    sound.add({.position = position, .reading = 0}, rowOf(1));
    wrong.add({.position = position, .reading = 0}, Json::object());
  }
  ASSERT_TRUE(sessionFromJson(json, sound));
  const auto expectFirst = [&](const SessionRows& rows, const std::string& path) {
    const Result<Session> session = sessionFromJson(json, rows);
    ASSERT_FALSE(session) << path;
    EXPECT_EQ(session.problem().where.path(), path);
  };
  SessionRows wrongLast;
  wrongLast.add({.position = 0, .reading = 0}, rowOf(1));
  wrongLast.add({.position = 1, .reading = 0}, Json::object());
  expectFirst(wrongLast, "positions[1].readings[0].horizontal");
  const std::pair<const char*, const char*> places[] = {
      {"/positions/1/readings", "positions[1].readings"},
      {"/positions/1/pointing_zero/horizontal", "positions[1].pointing_zero.horizontal"},
      {"/positions/1/axis_deg", "positions[1].axis_deg"}};
  for (const auto& [pointer, path] : places) {
    json[Json::json_pointer(pointer)] = nullptr;
    expectFirst(wrongLast, path);
  }
  expectFirst(wrong, "positions[0].readings[0].horizontal");
  for (const auto& [pointer, path] : {std::pair{"/positions/0/pointing_zero", "positions[0].pointing_zero"},
                                      {"/positions/0/axis_deg", "positions[0].axis_deg"},
                                      {"/model/effects", "model.effects"},
                                      {"/acceptance/coverage", "acceptance.coverage"},
                                      {"/geometry/radius_mm", "geometry.radius_mm"},
                                      {"/environment", "environment"},
                                      {"/instrument/sigma_zero_arcsec", "instrument.sigma_zero_arcsec"},
                                      {"/device/name", "device.name"},
                                      {"/report/number", "report.number"},
                                      {"/title", "title"},
                                      {"/version", "version"},
                                      {"/format", "format"}}) {
    json[Json::json_pointer(pointer)] = nullptr;
    expectFirst(wrong, path);
  }
}

// The document's origin keeps the place of a part, but not its values: the file would have them twice.
TEST(SessionFromJson, PutsEachValueIntoOneOrigin) {
  const Json json = soundDocument();
  SessionRows rows;
  rows.add({.position = 1, .reading = 0}, rowOf(7));
  const Result<Session> session = sessionFromJson(json, rows);
  ASSERT_TRUE(session) << session.problem().text();
  Json expected = json;
  for (const char* part :
       {"report", "device", "instrument", "environment", "geometry", "acceptance", "model", "positions"})
    expected[part] = nullptr;
  EXPECT_EQ(session->origin.object().dump(), expected.dump());
  EXPECT_EQ(session->geometry.origin.object().dump(), json["geometry"].dump());
  EXPECT_EQ(session->positions[1].origin.object().dump(),
            R"({"axis_deg":180,"pointing_zero":null,"readings":null})");
  EXPECT_EQ(session->positions[1].zero.origin.object().dump(), json["positions"][1]["pointing_zero"].dump());
  EXPECT_TRUE(session->positions[0].readings.empty());
  ASSERT_EQ(session->positions[1].readings.size(), 1u);
  EXPECT_EQ(session->positions[1].readings[0].horizontal, "7 0 0");
}

}  // namespace
}  // namespace alidade
