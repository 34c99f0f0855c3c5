#include "core/session/session_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>

namespace alidade {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// A session that uses every key of the format.
Json completeSession() {
  return Json::parse(R"({
    "format": "alidade-session", "version": 1,
    "title": "Table I", "notes": "n", "operator": "o", "place": "p", "measured_on": "2018-01-01",
    "report": {"number": "17", "laboratory": "l", "customer": "c", "authorised_by": "a", "rule_agreed_by": "r"},
    "device": {"name": "d", "serial": "1"},
    "instrument": {"name": "i", "serial": "2", "certificate": "3", "traceability": "t", "angle_unit": "gon", "sigma_horizontal_arcsec": 2, "sigma_vertical_arcsec": 2.5,
                   "sigma_zero_arcsec": 1, "sigma_slider_arcsec": 5},
    "environment": {"temperature_c": 20.0},
    "geometry": {"distance_mm": 2405, "sigma_distance_mm": 1.0, "radius_mm": 400, "sigma_radius_mm": 0.1,
                 "vertical_circle": "zenith", "pointing_zeros": "each", "plane": "vertical", "zero_is": "mark", "distance_from": "tape"},
    "acceptance": {"tolerance_mm": 2.5, "measurand": "distance", "coverage": 0.95, "reference_intersection_mm": 2.0, "sigma_reference_mm": 0.02},
    "model": {"vertical_angle": "exact", "radius": "known", "effects": ["trunnion_tilt"]},
    "positions": [
      {"axis_deg": 0, "pointing_zero": {"horizontal": "332°32'54\"", "vertical": 89.99916},
       "readings": [{"point": 1, "round": 1, "face": 1, "horizontal": "341°52'24\"", "vertical": "88°16'49\"",
                     "slider": "10°00'00\"", "excluded": true, "note": "wind"},
                    {"horizontal": 341, "vertical": "86 41 24"}]},
      {"axis_deg": 180, "pointing_zero": {"horizontal": "332 32 54", "vertical": "89 59 57"}, "readings": []}]})");
}

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The conditions on every session: reading and writing is lossless, and writing is stable.
void expectLossless(const std::string& text) {
  const Result<Session> session = readSession(text);
  ASSERT_TRUE(session) << session.problem().text();
  const std::string written = writeSession(*session);
  EXPECT_EQ(Json::parse(written).dump(), Json::parse(text).dump())
      << "same values, same keys in the same order";
  const Result<Session> again = readSession(written);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, *session);
  EXPECT_EQ(writeSession(*again), written);
}

std::string sentenceOn(const Json& json) {
  const Result<Session> session = readSession(json.dump());
  return session ? "accepted" : session.problem().text();
}

/// The complete session with the value at a JSON pointer replaced, or removed if it is discarded.
std::string sentenceWith(const char* pointer, const Json& value) {
  Json json = completeSession();
  json[Json::json_pointer(pointer)] = value;
  return sentenceOn(json);
}

std::string sentenceWithout(const char* parent, const char* key) {
  Json json = completeSession();
  json[Json::json_pointer(parent)].erase(key);
  return sentenceOn(json);
}

TEST(SessionFile, ReadsEveryKey) {
  const Result<Session> read = readSession(completeSession().dump());
  ASSERT_TRUE(read) << read.problem().text();
  const Session& s = *read;
  EXPECT_EQ(s.title + s.notes + s.operatorName + s.place + s.measuredOn, "Table Inop2018-01-01");
  EXPECT_EQ(s.report, (ReportEntries{"17", "l", "c", "a", "r", {}}));
  EXPECT_EQ(s.device, (Device{.name = "d", .serial = "1", .origin = {}}));
  EXPECT_EQ(s.instrument, (Instrument{"i", "2", "3", "t", "gon", "2", "2.5", "1", "5", "", {}, {}, {}, {}}));
  EXPECT_EQ(s.environment, (Environment{"20", "", {}}));
  EXPECT_EQ(s.geometry,
            (Geometry{"2405", "1", "400", "0.1", "zenith", "each", "vertical", "mark", "tape", "", "", {}}));
  EXPECT_EQ(s.acceptance, (Acceptance{"2.5", "distance", "0.95", "2", "0.02", {}}));
  EXPECT_EQ(s.model, (Model{"exact", "known", {"trunnion_tilt"}, {}}));
  ASSERT_EQ(s.positions.size(), 2u);
  EXPECT_EQ(s.positions[0].axisDeg, "0");
  EXPECT_EQ(s.positions[0].zero, (PointingZero{"332°32'54\"", "89.99916°", {}}));
  ASSERT_EQ(s.positions[0].readings.size(), 2u);
  EXPECT_EQ(s.positions[0].readings[0], (Reading{"1",
                                                 "1",
                                                 "1",
                                                 "341°52'24\"",
                                                 "88°16'49\"",
                                                 "10°00'00\"",
                                                 "",
                                                 "",
                                                 "",
                                                 "",
                                                 "",
                                                 "",
                                                 true,
                                                 "wind",
                                                 {},
                                                 {}}));
  EXPECT_EQ(s.positions[0].readings[1],
            (Reading{"", "", "", "341°", "86 41 24", "", "", "", "", "", "", "", false, "", {}, {}}));
  EXPECT_EQ(s.positions[1].axisDeg, "180");
}

TEST(SessionFile, LosesNothingOnEverySampleAndReferenceSession) {
  int count = 0;
  for (const char* folder : {ALIDADE_SAMPLES_DIR, ALIDADE_REFERENCE_DIR "/trials/sessions"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".alidade") continue;
      SCOPED_TRACE(entry.path().string());
      expectLossless(contentOf(entry.path()));
      ++count;
    }
  }
  EXPECT_GE(count, 10);
}

TEST(SessionFile, SamplesAreWrittenAsTheProgramWritesThem) {
  for (const auto& entry : std::filesystem::directory_iterator(ALIDADE_SAMPLES_DIR)) {
    if (entry.path().extension() != ".alidade") continue;
    const std::string text = contentOf(entry.path());
    EXPECT_EQ(writeSession(*readSession(text)), text) << entry.path();
  }
}

TEST(SessionFile, LosesNothingOfUnknownKeysAtEveryLevel) {
  Json json = completeSession();
  const Json unknown = Json::parse(
      R"({"z": [1, [2, {"deep": null}], {}], "a": "\u0000 \" \\ ″ 𝛼 \u2028", "big": 1e300, "tiny": -1e-300,
          "int": -9223372036854775808, "uint": 18446744073709551615, "zero": -0.0, "": true})");
  for (const char* level :
       {"", "/report", "/device", "/instrument", "/environment", "/geometry", "/acceptance", "/model",
        "/positions/0", "/positions/0/pointing_zero", "/positions/0/readings/0"}) {
    json[Json::json_pointer(std::string(level) + "/x-unknown")] = unknown;
  }
  expectLossless(json.dump());
}

TEST(SessionFile, LosesNothingWhereOptionalKeysAreAbsentEmptyOrInAnotherOrder) {
  expectLossless(
      R"({"positions": [{"readings": [], "pointing_zero": {"vertical": "", "horizontal": ""}, "axis_deg": ""}, 
                     {"axis_deg": 180, "pointing_zero": {"vertical": 90, "horizontal": 0.5}}],
                     "notes": "", "device": {}, "model": {}, "instrument": {"name": "", "sigma_zero_arcsec": ""},
                     "geometry": {"radius_mm": "4OO", "distance_mm": 2405.0}, "version": 1, "format": "alidade-session"})");
}

TEST(SessionFile, LosesNothingOfRandomValues) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 200; ++i) {
    Json json = completeSession();
    json["geometry"]["distance_mm"] = std::pow(10, exponent(random));
    json["acceptance"]["tolerance_mm"] = static_cast<std::int64_t>(random()) - (1 << 30);
    json["positions"][0]["pointing_zero"]["vertical"] = -std::pow(10, exponent(random) / 10);
    json["positions"][0]["readings"][0]["point"] = 1.0 / (i + 1);
    expectLossless(json.dump());
  }
}

TEST(SessionFile, ReadsAByteOrderMark) {
  EXPECT_TRUE(readSession("\xEF\xBB\xBF" + completeSession().dump()));
}

TEST(SessionFile, NamesWhatIsNoSessionAtAll) {
  EXPECT_THAT(readSession("").problem().text(), HasSubstr("is empty"));
  EXPECT_THAT(readSession("[1]").problem().text(), HasSubstr("is a list, not an object in braces"));
  EXPECT_THAT(readSession("{\"format\": 1,\n}").problem().text(), HasSubstr("line 2, column 1"));
  EXPECT_THAT(readSession("{}").problem().text(), HasSubstr("format: is missing"));
  EXPECT_THAT(sentenceWith("/format", "gsi"), HasSubstr("format: “gsi” is not \"alidade-session\""));
  EXPECT_THAT(sentenceWith("/format", 1), HasSubstr("format: is not"));
}

TEST(SessionFile, NamesTheVersionItCannotRead) {
  EXPECT_EQ(sentenceWith("/version", 3),
            "version: 3 is newer than the version this program reads (1): open it with a newer Alidade");
  EXPECT_THAT(sentenceWith("/version", 18446744073709551615ull), HasSubstr("is newer"));
  EXPECT_THAT(sentenceWith("/version", 0), HasSubstr("version: 0 is no version"));
  EXPECT_THAT(sentenceWith("/version", "1"), HasSubstr("version: must be the whole number 1, not a text"));
  EXPECT_THAT(sentenceWith("/version", 1.5), HasSubstr("version: must be the whole number 1, not 1.5"));
  EXPECT_THAT(sentenceWith("/version", 2.0), HasSubstr("version: 2.0 is newer"));
  EXPECT_EQ(sentenceWith("/version", 1.0), "accepted");
  EXPECT_THAT(sentenceWithout("", "version"), HasSubstr("version: is missing"));
}

TEST(SessionFile, ANewerVersionIsNamedBeforeAnythingItMayHaveChanged) {
  EXPECT_THAT(sentenceOn(Json{{"format", "alidade-session"}, {"version", 2}}),
              HasSubstr("version: 2 is newer"));
}

TEST(SessionFile, NamesMissingRequiredKeys) {
  EXPECT_THAT(sentenceWithout("", "geometry"), HasSubstr("geometry: is missing: add"));
  EXPECT_THAT(sentenceWithout("", "positions"), HasSubstr("positions: is missing: add"));
  EXPECT_THAT(sentenceWithout("/geometry", "distance_mm"),
              HasSubstr("geometry.distance_mm: is missing: add the distance"));
  EXPECT_THAT(sentenceWithout("/geometry", "radius_mm"), HasSubstr("geometry.radius_mm: is missing"));
  EXPECT_THAT(sentenceWithout("/positions/1", "axis_deg"), HasSubstr("positions[1].axis_deg: is missing"));
  EXPECT_THAT(sentenceWithout("/positions/1", "pointing_zero"),
              HasSubstr("positions[1].pointing_zero: is missing"));
  EXPECT_THAT(sentenceWithout("/positions/0/pointing_zero", "vertical"),
              HasSubstr("positions[0].pointing_zero.vertical: is missing"));
  EXPECT_THAT(sentenceWithout("/positions/0/readings/1", "vertical"),
              HasSubstr("positions[0].readings[1].vertical: is missing: add the reading"));
}

TEST(SessionFile, NamesWrongTypes) {
  EXPECT_EQ(sentenceWith("/geometry/distance_mm", true), "geometry.distance_mm: must be a number, not true");
  EXPECT_EQ(sentenceWith("/geometry/distance_mm", nullptr),
            "geometry.distance_mm: must be a number, not null");
  EXPECT_THAT(sentenceWith("/title", 5), HasSubstr("title: must be a text in quotation marks, not a number"));
  EXPECT_THAT(sentenceWith("/device", "x"), HasSubstr("device: must be an object in braces, not a text"));
  EXPECT_THAT(sentenceWith("/positions", Json::object()), HasSubstr("positions: must be a list"));
  EXPECT_THAT(sentenceWith("/positions/1", 7), HasSubstr("positions[1]: must be an object"));
  EXPECT_THAT(sentenceWith("/positions/0/readings", 7), HasSubstr("positions[0].readings: must be a list"));
  EXPECT_THAT(sentenceWith("/positions/0/readings/1", "x"),
              HasSubstr("positions[0].readings[1]: must be an object"));
  EXPECT_THAT(sentenceWith("/positions/0/readings/1/horizontal", Json::array()),
              HasSubstr("positions[0].readings[1].horizontal: must be an angle"));
  EXPECT_THAT(sentenceWith("/positions/0/readings/1/excluded", 1),
              HasSubstr("positions[0].readings[1].excluded: must be true or false, not a number"));
  EXPECT_THAT(sentenceWith("/model/effects", "tilt"), HasSubstr("model.effects: must be a list"));
}

TEST(SessionFile, KeepsTextsThatMeanNothing) {
  EXPECT_EQ(sentenceWith("/geometry/distance_mm", "about 2400"), "accepted");
  EXPECT_EQ(sentenceWith("/positions/0/readings/0/vertical", "88°71'49\""), "accepted");
}

TEST(SessionFile, WritesANewSessionInTheOrderOfTheFormat) {
  Session session = blankSession();
  session.positions[0].readings.push_back({});
  session.positions[0].readings[0].horizontal = "3415224";
  session.positions[0].readings[0].excluded = true;
  EXPECT_EQ(writeSession(session),
            "{\n"
            "  \"format\": \"alidade-session\",\n"
            "  \"version\": 1,\n"
            "  \"instrument\": {\n"
            "    \"sigma_horizontal_arcsec\": 2,\n"
            "    \"sigma_vertical_arcsec\": 2,\n"
            "    \"sigma_zero_arcsec\": 2\n"
            "  },\n"
            "  \"geometry\": {\n"
            "    \"distance_mm\": \"\",\n"
            "    \"radius_mm\": \"\",\n"
            "    \"vertical_circle\": \"zenith\"\n"
            "  },\n"
            "  \"acceptance\": {\n"
            "    \"coverage\": 0.95\n"
            "  },\n"
            "  \"model\": {\n"
            "    \"vertical_angle\": \"exact\"\n"
            "  },\n"
            "  \"positions\": [\n"
            "    {\n"
            "      \"axis_deg\": 0,\n"
            "      \"pointing_zero\": {\"horizontal\": \"\", \"vertical\": \"\"},\n"
            "      \"readings\": [\n"
            "        {\"horizontal\": \"3415224\", \"vertical\": \"\", \"excluded\": true}\n"
            "      ]\n"
            "    },\n"
            "    {\n"
            "      \"axis_deg\": 180,\n"
            "      \"pointing_zero\": {\"horizontal\": \"\", \"vertical\": \"\"},\n"
            "      \"readings\": []\n"
            "    }\n"
            "  ]\n"
            "}\n");
  EXPECT_EQ(*readSession(writeSession(session)), session);
}

TEST(SessionFile, WritesEditsAndLeavesTheRestUntouched) {
  Session session = *readSession(completeSession().dump());
  session.geometry.distanceMm = "2406,5";
  session.acceptance.toleranceMm = "";
  session.geometry.radiusMm = "";
  session.positions[0].readings[0].vertical = "88 16 50";
  session.positions[0].readings[0].excluded = false;
  session.positions[0].readings[1].point = "x";
  session.positions[0].zero.vertical = "89.999°";
  Json expected = completeSession();
  expected["geometry"]["distance_mm"] = 2406.5;
  expected["acceptance"].erase("tolerance_mm");
  expected["geometry"]["radius_mm"] = "";
  expected["positions"][0]["readings"][0]["vertical"] = "88 16 50";
  expected["positions"][0]["readings"][0]["excluded"] = false;
  expected["positions"][0]["readings"][1]["point"] = "x";
  expected["positions"][0]["pointing_zero"]["vertical"] = "89.999°";
  EXPECT_EQ(Json::parse(writeSession(session)).dump(), expected.dump());
}

TEST(SessionFile, KeepsWhatItDoesNotKnowAmongTheEffects) {
  Json json = completeSession();
  json["model"]["effects"] = {"moonlight", 7, "trunnion_tilt"};
  Session session = *readSession(json.dump());
  EXPECT_EQ(session.model.effects, (std::vector<std::string>{"moonlight", "7", "trunnion_tilt"}));
  session.model.effects = {"moonlight", "7", "collimation"};
  json["model"]["effects"] = {"moonlight", 7, "collimation"};
  EXPECT_EQ(Json::parse(writeSession(session)), json);
}

TEST(SessionFile, KeepsWhatIsKnownOfInstrumentAndDevice) {
  Json json = completeSession();
  const Json collimation = {{"effect", "collimation"}, {"value", 3.2},    {"sigma", 0.5},
                            {"unit", "arcsec"},        {"from", "check"}, {"colour", "red"}};
  json["instrument"]["known"] = Json::array({collimation});
  json["device"]["known"] = {
      {{"effect", "plane_tilt"}, {"parameter", "tilt about x"}, {"sigma", 0.01}, {"unit", "deg"}}};
  Session session = *readSession(json.dump());
  EXPECT_EQ(session.instrument.known,
            (std::vector<KnownSize>{{"collimation", "", "3.2", "0.5", "arcsec", "check", {}}}));
  EXPECT_EQ(session.device.known,
            (std::vector<KnownSize>{{"plane_tilt", "tilt about x", "", "0.01", "deg", "", {}}}));
  EXPECT_EQ(Json::parse(writeSession(session)), json);
  session.instrument.known[0].sigma = "0.25";
  session.device.known.clear();
  json["instrument"]["known"][0]["sigma"] = 0.25;
  json["device"]["known"] = Json::array();
  EXPECT_EQ(Json::parse(writeSession(session)), json);
  json["instrument"]["known"] = {7};
  EXPECT_THAT(sentenceOn(json), HasSubstr("instrument.known[0]"));
  json["instrument"]["known"] = {{{"effect", 7}}};
  EXPECT_THAT(sentenceOn(json), HasSubstr("instrument.known[0].effect"));
}

TEST(SessionFile, NamesTheRecordThatWhatIsKnownIsFrom) {
  Json json = completeSession();
  json["instrument"]["record"] = {
      {"file", "t-1.alidade-instrument"}, {"date", "2026-03-01"}, {"colour", "red"}};
  json["instrument"]["known"] = {{{"effect", "collimation"}, {"sigma", 1}, {"date", "2026-02-27"}}};
  Session session = *readSession(json.dump());
  EXPECT_EQ(session.instrument.record, (NamedRecord{"t-1.alidade-instrument", "2026-03-01"}));
  EXPECT_EQ(session.instrument.known.at(0).date, "2026-02-27");
  EXPECT_EQ(Json::parse(writeSession(session)), json);
  session.instrument.record.date = "2026-03-02";
  json["instrument"]["record"]["date"] = "2026-03-02";
  EXPECT_EQ(Json::parse(writeSession(session)), json);
  json["instrument"]["record"] = "t-1";
  EXPECT_THAT(sentenceOn(json), HasSubstr("instrument.record: must be an object"));
}

TEST(SessionFile, WritesNothingKnownUntilThereIsSomething) {
  Session session = blankSession();
  EXPECT_FALSE(Json::parse(writeSession(session))["instrument"].contains("known"));
  EXPECT_FALSE(Json::parse(writeSession(session))["instrument"].contains("record"));
  session.instrument.known = {{.effect = "collimation", .sigma = "1", .unit = "arcsec"}};
  EXPECT_EQ(readSession(writeSession(session))->instrument.known, session.instrument.known);
}

TEST(SessionFile, WritesNothingOfAReportUntilThereIsSomething) {
  Session session = blankSession();
  const Json empty = Json::parse(writeSession(session));
  EXPECT_FALSE(empty.contains("report"));
  for (const char* key : {"certificate", "traceability", "angle_unit"})
    EXPECT_FALSE(empty["instrument"].contains(key));
  EXPECT_FALSE(empty["geometry"].contains("distance_from"));
  session.report.customer = "c";
  EXPECT_EQ(Json::parse(writeSession(session))["report"].dump(), R"({"customer":"c"})");
  EXPECT_EQ(readSession(writeSession(session))->report, session.report);
  Json json = completeSession();
  json["report"] = {{"number", "17"}, {"seal", "red"}};
  Session sealed = *readSession(json.dump());
  sealed.report.number.clear();
  EXPECT_EQ(Json::parse(writeSession(sealed))["report"].dump(), R"({"seal":"red"})");
}

TEST(SessionFile, WritesNoListOfEffectsUntilThereIsOne) {
  Session session = blankSession();
  EXPECT_FALSE(Json::parse(writeSession(session))["model"].contains("effects"));
  session.model.effects = {"collimation"};
  EXPECT_EQ(readSession(writeSession(session))->model.effects, session.model.effects);
}

TEST(SessionFile, RowsKeepTheirUnknownKeysWhenTheyMove) {
  Json json = completeSession();
  json["positions"][0]["readings"][1]["weather"] = "sun";
  Session session = *readSession(json.dump());
  auto& readings = session.positions[0].readings;
  std::swap(readings[0], readings[1]);
  readings.insert(readings.begin(), Reading{});
  const Json written = Json::parse(writeSession(session));
  EXPECT_EQ(written["positions"][0]["readings"][1]["weather"], "sun");
  EXPECT_FALSE(written["positions"][0]["readings"][2].contains("weather"));
}

// Rows that differ only in their texts share the rest.
TEST(SessionFile, KeepsEveryWayToWriteARow) {
  Json json = completeSession();
  Json& rows = json["positions"][0]["readings"];
  const Json first = rows[0];
  rows = Json::array();
  const char* ways[] = {
      R"({"point": 1, "horizontal": "1 2 3", "vertical": "90 0 0"})",
      R"({"point": 2, "horizontal": "1 2 4", "vertical": "90 0 1"})",
      R"({"point": 3.0, "horizontal": "1 2 5", "vertical": "90 0 1"})",
      R"({"point": "4", "horizontal": "", "vertical": 90})",
      R"({"point": 5, "horizontal": "1 2 6", "vertical": 90.5})",
      R"({"point": 6, "horizontal": "1 2 7", "vertical": 90.5})",
      R"({"vertical": "90 0 0", "point": 7, "horizontal": "1 2 3", "note": "", "slider": ""})",
      R"({"vertical": "90 0 1", "point": 8, "horizontal": "1 2 3", "note": "n", "slider": "1"})",
      R"({"vertical": "90 0 2", "point": 9, "horizontal": "1 2 3", "note": "", "slider": ""})",
      R"({"point": 10, "horizontal": "1 2 3", "vertical": "90 0 0", "excluded": false})",
      R"({"point": 11, "horizontal": "1 2 4", "vertical": "90 0 1", "excluded": true})",
      R"({"point": 12, "horizontal": "1 2 3", "vertical": "90 0 0", "x": null, "y": {"z": 1}})",
      R"({"point": 13, "horizontal": "1 2 3", "vertical": "90 0 0", "x": null, "y": {"z": 1.0}})"};
  for (const char* way : ways) rows.push_back(Json::parse(way));
  Session session = *readSession(json.dump());
  EXPECT_EQ(Json::parse(writeSession(session)).dump(), json.dump());
  session.positions[0].readings[1].point = "";
  session.positions[0].readings[7].note = "";
  session.positions[0].readings[8].slider = "2 0 0";
  session.positions[0].readings[10].excluded = false;
  rows[1].erase("point");
  rows[7].erase("note");
  rows[8]["slider"] = "2 0 0";
  rows[10]["excluded"] = false;
  EXPECT_EQ(Json::parse(writeSession(session)).dump(), json.dump());
}

TEST(SessionFile, WritesTextThatIsNotUtf8WithoutFailing) {
  Session session = blankSession();
  session.notes = "a\xFF";
  EXPECT_EQ(readSession(writeSession(session))->notes, "a\uFFFD");
}

TEST(SessionFile, TakesTimeInProportionToItsSize) {
  Json json = completeSession();
  const Json reading = json["positions"][0]["readings"][0];
  for (int i = 0; i < 100000; ++i) json["positions"][1]["readings"].push_back(reading);
  std::string members = "{";
  for (int i = 0; i < 100000; ++i) members += (i ? ",\"k" : "\"k") + std::to_string(i) + "\":1";
  std::string text = json.dump();
  text.insert(1, "\"unknown\":" + members + "},");

  const auto start = std::chrono::steady_clock::now();
  const Result<Session> session = readSession(text);
  ASSERT_TRUE(session) << session.problem().text();
  EXPECT_GT(writeSession(*session).size(), text.size());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed.count(), 60) << "a second or two in a release build; minutes if anything were quadratic";
}

TEST(SessionFile, MutilatedFilesAreRefusedOrReadButNeverCrash) {
  const std::string text = completeSession().dump();
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> at(0, text.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);
  int refused = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = text;
    if (i % 2) damaged.resize(at(random));
    for (int n = i % 4; n > 0 && !damaged.empty(); --n)
      damaged[at(random) % damaged.size()] = static_cast<char>(byte(random));
    const Result<Session> session = readSession(damaged);
    if (session) {
      EXPECT_TRUE(readSession(writeSession(*session)));
    } else {
      ++refused;
      EXPECT_FALSE(session.problem().what.empty());
    }
  }
  EXPECT_GT(refused, 2500);
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content)
      : m_path(std::filesystem::path(testing::TempDir()) /
               ("alidade-" + std::to_string(std::random_device()()) + ".alidade")) {
    std::ofstream(m_path, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(m_path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return m_path.string(); }

 private:
  std::filesystem::path m_path;
};

TEST(SessionFile, LoadsFromDisk) {
  const TemporaryFile file(completeSession().dump());
  const Result<Session> session = loadSession(file.path());
  ASSERT_TRUE(session);
  EXPECT_EQ(session->title, "Table I");
}

TEST(SessionFile, NamesTheTroubleOfAFile) {
  EXPECT_THAT(loadSession("/nonexistent/x.alidade").problem().what,
              HasSubstr("cannot be opened (No such file or directory): check its name"));
  EXPECT_THAT(loadSession(testing::TempDir()).problem().what, HasSubstr("is a folder"));
  const TemporaryFile empty("");
  EXPECT_THAT(loadSession(empty.path()).problem().what, HasSubstr("is empty"));
}

}  // namespace
}  // namespace alidade
