#include "core/session/session_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

std::string written(const Session& session) {
  return Json::parse(writeSession(session)).dump();
}

Session read(const Json& json) {
  return *readSession(json.dump());
}

/// A document written by another program: keys in a different order, and unknown keys.
Json foreignDocument() {
  return Json::parse(R"({
    "positions": [
      {"readings": [
         {"vertical": "90 0 0", "horizontal": "1 0 0", "weather": "sun", "excluded": true},
         {"horizontal": 2.5, "vertical": "90 0 0", "point": 2, "excluded": false, "note": "n", "slider": "5°"}],
       "pointing_zero": {"vertical": 90.0, "horizontal": "0 0 1", "by": "a"}, "axis_deg": 180.0},
      {"axis_deg": "0", "pointing_zero": {"horizontal": "3 0 0", "vertical": "90 0 1"}, "lamp": 1}],
    "version": 1.0, "format": "alidade-session", "title": "t", "measured_on": "2018-01-01",
    "geometry": {"radius_mm": 400.0, "distance_mm": 2405, "sigma_distance_mm": "1,50"},
    "instrument": {"serial": "7", "sigma_slider_arcsec": 5e0}, "device": {"name": ""},
    "model": {"effects": ["trunnion_tilt", 7, {"deep": 1.0}, "collimation"], "radius": "free"}})");
}

// A session that was typed instead of read: in the order of the format, a number if its text is one.
TEST(SessionWriter, SpellsOutEverythingThatASessionHolds) {
  Session session;
  session.title = "t";
  session.notes = "n";
  session.operatorName = "o";
  session.place = "p";
  session.measuredOn = "2018-01-01";
  session.report = {"17", "l", "c", "a", "r", {}};
  session.device.name = "d";
  session.device.serial = "1";
  session.instrument = {"i", "2", "c", "t", "degrees", "2,5", "3", "about 1", "5.0", "0.5", {}, {}, {}, {}};
  session.environment = {"-3", "0.5", {}};
  session.geometry = {"2405",   "0.5",    "400",   "0", "elevation", "one",
                      "square", "normal", "laser", "1", "11.5",      {}};
  session.acceptance = {"2.5", "distance", "0.95", "-1", "0.1", {}};
  session.model = {"planar", "known", {"b", "a"}, {}};
  Position& position = session.positions.emplace_back();
  position.axisDeg = "180";
  position.zero = {"1°", "90 0 0", {"181 0 0", "270 0 1"}, {"1 0 1", ""}, {"", "x"}, {}};
  position.zero.takenAt = "2026-03-14T15:00:00Z";
  position.zero.after.takenAt = "2026-03-14T16:00:00Z";
  position.zero.after.returnCode = "0";
  position.readings = {{"1",
                        "2",
                        "x",
                        "10",
                        "20",
                        "30",
                        "-1.5",
                        "2",
                        "none",
                        "2026-03-14T15:09:26+01:00",
                        "1284",
                        "123",
                        true,
                        "r",
                        {},
                        {}},
                       {}};
  const Json expected = Json::parse(R"({
    "format": "alidade-session", "version": 1, "title": "t", "notes": "n", "operator": "o", "place": "p",
    "measured_on": "2018-01-01",
    "report": {"number": "17", "laboratory": "l", "customer": "c", "authorised_by": "a", "rule_agreed_by": "r"},
    "device": {"name": "d", "serial": "1"},
    "instrument": {"name": "i", "serial": "2", "certificate": "c", "traceability": "t", "angle_unit": "degrees", "sigma_horizontal_arcsec": 2.5, "sigma_vertical_arcsec": 3,
                   "sigma_zero_arcsec": "about 1", "sigma_slider_arcsec": 5, "sigma_compensator_arcsec": 0.5},
    "environment": {"temperature_c": -3, "sigma_temperature_c": 0.5},
    "geometry": {"distance_mm": 2405, "sigma_distance_mm": 0.5, "radius_mm": 400, "sigma_radius_mm": 0,
                 "vertical_circle": "elevation", "pointing_zeros": "one", "plane": "square", "zero_is": "normal", "distance_from": "laser", "distance_expansion_ppm_per_k": 1, "radius_expansion_ppm_per_k": 11.5},
    "acceptance": {"tolerance_mm": 2.5, "measurand": "distance", "coverage": 0.95, "reference_intersection_mm": -1, "sigma_reference_mm": 0.1},
    "model": {"vertical_angle": "planar", "radius": "known", "effects": ["b", "a"]},
    "positions": [{"axis_deg": 180, "pointing_zero": {"horizontal": "1°", "vertical": "90 0 0",
      "taken_at": "2026-03-14T15:00:00Z", "face_2": {"horizontal": "181 0 0", "vertical": "270 0 1"}, "after": {"horizontal": "1 0 1",
      "taken_at": "2026-03-14T16:00:00Z", "return_code": 0},
      "after_face_2": {"vertical": "x"}}, "readings": [
      {"point": 1, "round": 2, "face": "x", "horizontal": "10", "vertical": "20", "slider": "30",
       "tilt_cross_arcsec": -1.5, "tilt_length_arcsec": 2, "corrections": "none", "taken_at": "2026-03-14T15:09:26+01:00",
       "return_code": 1284, "instrument_serial": "123", "excluded": true, "note": "r"},
      {"horizontal": "", "vertical": ""}]}]})");
  EXPECT_EQ(written(session), expected.dump());
}

// Data from the instrument with rows and zeros are read and written back unchanged, whatever their content.
TEST(SessionWriter, KeepsWhatCameFromTheInstrument) {
  const Json document = Json::parse(R"({"format": "alidade-session", "version": 1,
    "geometry": {"distance_mm": 2405, "radius_mm": 400}, "positions": [{"axis_deg": 0,
    "pointing_zero": {"horizontal": "1 0 0", "taken_at": "2026-03-14T15:00:00Z", "vertical": "90 0 0",
      "after": {"taken_at": "then", "horizontal": "1 0 1", "vertical": "90 0 1", "return_code": 1284}},
    "readings": [{"return_code": 1283, "horizontal": "10 0 0", "vertical": "80 0 0", "taken_at": "2026-03-14T15:09:26+01:00"},
      {"horizontal": "11 0 0", "vertical": "80 0 0", "return_code": "C7", "instrument_serial": "123"}]}]})");
  Session session = read(document);
  EXPECT_EQ(written(session), document.dump());
  EXPECT_EQ(session.positions[0].zero.takenAt, "2026-03-14T15:00:00Z");
  EXPECT_EQ(session.positions[0].zero.after.takenAt, "then");
  EXPECT_EQ(session.positions[0].zero.after.returnCode, "1284");
  EXPECT_EQ(session.positions[0].readings[0].returnCode, "1283");
  EXPECT_EQ(session.positions[0].readings[1].returnCode, "C7");
  EXPECT_TRUE(examine(session).problems.empty()) << "nothing is computed from it";
  Session other = session;
  other.positions[0].readings[0].takenAt = "later";
  EXPECT_NE(other, session);
}

TEST(SessionWriter, LeavesOutWhatNobodyTyped) {
  Session session;
  session.positions.emplace_back();
  EXPECT_EQ(
      written(session),
      R"({"format":"alidade-session","version":1,"geometry":{"distance_mm":"","radius_mm":""},)"
      R"("positions":[{"axis_deg":"","pointing_zero":{"horizontal":"","vertical":""},"readings":[]}]})");
}

TEST(SessionWriter, WritesWhatWasTakenBackAsItWasRead) {
  Session session = read(foreignDocument());
  const Session untouched = session;
  session.geometry.radiusMm = session.geometry.sigmaDistanceMm = session.positions[0].axisDeg = "1";
  session.positions[0].readings[0].excluded = false;
  session.positions[0].readings[1].excluded = true;
  session.positions[0].readings[1].horizontal = "2.50°";
  session.positions[0].zero.vertical.clear();
  session.model.effects.clear();
  EXPECT_NE(written(session), foreignDocument().dump());
  session.geometry = untouched.geometry;
  session.model = untouched.model;
  session.positions = untouched.positions;
  EXPECT_EQ(written(session), foreignDocument().dump());
}

/// Returns the part as it is after its table was emptied: with its origin only.
template <typename Part>
Part emptied(const Part& part) {
  Part empty;
  empty.origin = part.origin;
  return empty;
}

// Keys required by the format stay with an empty text; the others are removed.
TEST(SessionWriter, LeavesOutWhatWasEmptied) {
  Session session = read(foreignDocument());
  session.title.clear();
  session.geometry = emptied(session.geometry);
  session.instrument = emptied(session.instrument);
  for (Position& position : session.positions) {
    position.axisDeg.clear();
    position.zero = emptied(position.zero);
    for (Reading& reading : position.readings) reading = emptied(reading);
  }
  Json expected = foreignDocument();
  expected.erase("title");
  expected["geometry"] = {{"radius_mm", ""}, {"distance_mm", ""}};
  expected["instrument"] = Json::object();
  expected["positions"] = Json::parse(R"([
    {"readings": [{"vertical": "", "horizontal": "", "weather": "sun", "excluded": false},
                  {"horizontal": "", "vertical": "", "excluded": false}],
     "pointing_zero": {"vertical": "", "horizontal": "", "by": "a"}, "axis_deg": ""},
    {"axis_deg": "", "pointing_zero": {"horizontal": "", "vertical": ""}, "lamp": 1}])");
  EXPECT_EQ(written(session), expected.dump());
}

TEST(SessionWriter, MovesWhatIsUnknownAlongWithItsPart) {
  Session session = read(foreignDocument());
  Json expected = foreignDocument();
  std::ranges::reverse(session.model.effects);
  std::ranges::reverse(expected["model"]["effects"]);
  std::swap(session.positions[0], session.positions[1]);
  std::swap(expected["positions"][0], expected["positions"][1]);
  EXPECT_EQ(written(session), expected.dump());

  // The reading is moved between positions, one of which had no list of rows and receives one.
  session.positions[0].readings.push_back(session.positions[1].readings[0]);
  session.positions[1].readings.erase(session.positions[1].readings.begin());
  expected["positions"][0]["readings"] = Json::array({expected["positions"][1]["readings"][0]});
  expected["positions"][1]["readings"].erase(0);
  EXPECT_EQ(written(session), expected.dump());
}

}  // namespace
}  // namespace alidade
