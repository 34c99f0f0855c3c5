#include "core/session/row_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/exchange/import.h"
#include "core/exchange/table_layout.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A text that only the rule of free texts accepts.
constexpr const char* nonsense = "nonsense";

/// One row with a text in every field.
Session sessionOfOneRow(const std::string& text) {
  Session session = blankSession();
  Position& position = session.positions[0];
  position.zero = {.horizontal = "0°", .vertical = "90°", .origin = {}};
  position.readings.resize(1);
  for (const RowField& field : rowFields)
    if (field.text) position.readings[0].*field.text = text;
  return session;
}

// The order of the keys of a new row, as in existing files.
TEST(RowFields, AreWrittenInTheOrderOfTheFile) {
  Session session = sessionOfOneRow("1");
  session.positions[0].readings[0].excluded = true;
  const auto json = nlohmann::ordered_json::parse(writeSession(session));
  std::vector<std::string> keys;
  for (const auto& [key, value] : json["positions"][0]["readings"][0].items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("point", "round", "face", "horizontal", "vertical", "slider",
                                "tilt_cross_arcsec", "tilt_length_arcsec", "corrections", "taken_at",
                                "return_code", "instrument_serial", "excluded", "note"));
}

TEST(RowFields, SurviveTheFile) {
  Session session = sessionOfOneRow(nonsense);
  session.positions[0].readings[0].excluded = true;
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  const Result<Session> read = readSession(writeSession(session));
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(read->positions[0].readings, session.positions[0].readings);
}

// A text that its rule refuses is reported at its place by both the session check and the single entry check.
TEST(RowFields, AreCheckedByTheirRules) {
  const Session session = sessionOfOneRow(nonsense);
  std::set<std::string> reported;
  for (const Problem& problem : examine(session).problems)
    if (problem.where.reading) reported.insert(problem.where.field);
  for (const RowField& field : rowFields) {
    if (!field.text) continue;
    const bool isRefused = entryProblem(field, nonsense, VerticalCircle::Zenith).has_value();
    EXPECT_NE(isRefused, isFreeText(field)) << field.key;
    EXPECT_EQ(reported.contains(std::string(field.key)), isRefused) << field.key;
    const std::string name = "readings." + std::string(field.key);
    EXPECT_EQ(entryProblem(session, name, nonsense).has_value(), isRefused) << field.key;
  }
}

/// A text that its rule accepts.
std::string soundText(const RowField& field) {
  if (std::holds_alternative<CorrectionsRule>(field.rule)) return "collimation";
  if (std::holds_alternative<NumberText>(field.rule)) return "1284";
  return isAngle(field) ? "12 00 00" : isFreeText(field) ? "said" : "2";
}

TEST(RowFields, ComeFromTables) {
  std::string names, cells;
  for (const RowField& field : rowFields) {
    names += std::string(field.key) + ";";
    cells += (field.flag ? "yes" : soundText(field)) + ";";
  }
  const std::string table = names + "\n" + cells + "\n";
  const Result<Import> import = importReadings({{.name = {}, .bytes = table}});
  ASSERT_TRUE(import);
  EXPECT_THAT(import->problems, IsEmpty());
  const Reading& row = import->session.positions.at(0).readings.at(0);
  for (const RowField& field : rowFields) {
    if (field.flag)
      EXPECT_TRUE(row.*field.flag) << field.key;
    else
      EXPECT_EQ(row.*field.text, soundText(field)) << field.key;
  }
}

// The file's name of the field also names its column.
TEST(RowFields, AreToldApartByTheirKeys) {
  for (const RowField& field : rowFields)
    EXPECT_EQ(columnName(std::string(field.key)).column, TableColumn{&field}) << field.key;
}

// Common names of tilt columns; a tilt in another unit is ignored.
TEST(RowFields, KnowHowTiltsAreNamed) {
  for (const char* name : {"Cross tilt", "tilt_cross_arcsec", "Transverse inclination [arcsec]"})
    EXPECT_EQ(columnName(name).column, TableColumn{&rowField(&Reading::tiltCrossArcsec)}) << name;
  for (const char* name : {"Length tilt", "TILT-LENGTH-ARCSEC", "longitudinal incline"})
    EXPECT_EQ(columnName(name).column, TableColumn{&rowField(&Reading::tiltLengthArcsec)}) << name;
  for (const char* name : {"Tilt", "cross", "cross tilt mrad"})
    EXPECT_EQ(columnName(name).column, std::nullopt) << name;
}

TEST(RowFields, RefuseTiltsAndCorrectionsThatMeanNothing) {
  const auto said = [](std::string Reading::*text, const char* typed) {
    const auto problem = entryProblem(rowField(text), typed, VerticalCircle::Zenith);
    return problem ? problem->what : std::string();
  };
  for (const char* typed : {"", "-12.5", "3599.9", "0"})
    EXPECT_EQ(said(&Reading::tiltCrossArcsec, typed), "");
  EXPECT_EQ(said(&Reading::tiltLengthArcsec, "-3600"),
            "“-3600” is out of range: a tilt must be below 3600 arcseconds in size");
  for (const char* typed :
       {"", "none", "inclination", " tilting_axis  collimation standing_axis inclination"})
    EXPECT_EQ(said(&Reading::corrections, typed), "") << typed;
  for (const char* typed :
       {"on", "none inclination", "inclination none", "Inclination", "inclination,collimation"})
    EXPECT_THAT(said(&Reading::corrections, typed), testing::HasSubstr("names no corrections")) << typed;
}

// Rows without statements of the compensator are written unchanged.
TEST(RowFields, OfTheCompensatorAreWrittenWhereTheyAre) {
  Session session = blankSession();
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  session.positions[0].readings.resize(1);
  session.positions[0].readings[0].horizontal = "1°";
  session.positions[0].readings[0].vertical = "90°";
  EXPECT_THAT(writeSession(session), testing::Not(testing::HasSubstr("tilt")));
  EXPECT_FALSE(hasCompensatorTexts(session));
  Reading& row = session.positions[0].readings[0];
  row.tiltCrossArcsec = "-12.50";
  row.tiltLengthArcsec = "4";
  row.corrections = "none";
  EXPECT_TRUE(hasCompensatorTexts(session));
  const std::string file = writeSession(session);
  EXPECT_THAT(file, testing::HasSubstr(
                        R"("tilt_cross_arcsec": -12.5, "tilt_length_arcsec": 4, "corrections": "none")"));
  const Result<Session> read = readSession(file);
  ASSERT_TRUE(read) << read.problem().text();
  EXPECT_EQ(read->positions[0].readings[0].tiltCrossArcsec, "-12.5");
  EXPECT_EQ(writeSession(*read), file);
  const Sighting sighting = examine([&] {
                              Session sound = *read;
                              sound.positions[0].zero = {.horizontal = "0°", .vertical = "90°", .origin = {}};
                              return sound;
                            }())
                                .measurement->arcs.at(0)
                                .sightings.at(0);
  EXPECT_DOUBLE_EQ(sighting.tiltCross->arcseconds(), -12.5);
  EXPECT_DOUBLE_EQ(sighting.tiltLength->arcseconds(), 4);
  EXPECT_EQ(sighting.corrections, Corrections());
}

TEST(RowFields, KnowWhatAnEmptyTextStandsFor) {
  EXPECT_EQ(usualText(rowField(&Reading::round)), "1");
  EXPECT_EQ(usualText(rowField(&Reading::face)), "1");
  for (const auto text : {&Reading::point, &Reading::horizontal, &Reading::slider, &Reading::note})
    EXPECT_EQ(usualText(rowField(text)), "");
}

// Excluding a row does not count as typing in it; each text does.
TEST(RowFields, TellABlankRow) {
  Reading row;
  row.excluded = true;
  EXPECT_TRUE(isBlank(row));
  for (const RowField& field : rowFields) {
    if (!field.text) continue;
    row = {};
    row.*field.text = " ";
    EXPECT_FALSE(isBlank(row)) << field.key;
  }
}

TEST(RowFields, AreFoundByName) {
  for (const RowField& field : rowFields) EXPECT_EQ(rowFieldNamed(field.key), &field);
  EXPECT_EQ(rowFieldNamed("readings.point"), nullptr);
  EXPECT_EQ(rowFieldNamed(""), nullptr);
}

}  // namespace
}  // namespace alidade
