#include "core/session/row_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/exchange/import.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A text that no rule but that of free texts lets through.
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

// The order of the keys of a row that is new, as in the files written so far.
TEST(RowFields, AreWrittenInTheOrderOfTheFile) {
  Session session = sessionOfOneRow("1");
  session.positions[0].readings[0].excluded = true;
  const auto json = nlohmann::ordered_json::parse(writeSession(session));
  std::vector<std::string> keys;
  for (const auto& [key, value] : json["positions"][0]["readings"][0].items()) keys.push_back(key);
  EXPECT_THAT(keys,
              ElementsAre("point", "round", "face", "horizontal", "vertical", "slider", "excluded", "note"));
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

// Whatever its rule refuses, the check of the whole session and that of the single entry tell at its place.
TEST(RowFields, AreCheckedByTheirRules) {
  const Session session = sessionOfOneRow(nonsense);
  std::set<std::string> told;
  for (const Problem& problem : examine(session).problems)
    if (problem.where.reading) told.insert(problem.where.field);
  for (const RowField& field : rowFields) {
    if (!field.text) continue;
    const bool isRefused = entryProblem(field, nonsense, VerticalCircle::Zenith).has_value();
    EXPECT_NE(isRefused, isFreeText(field)) << field.key;
    EXPECT_EQ(told.contains(std::string(field.key)), isRefused) << field.key;
    const std::string name = "readings." + std::string(field.key);
    EXPECT_EQ(entryProblem(session, name, nonsense).has_value(), isRefused) << field.key;
  }
}

TEST(RowFields, ComeFromTables) {
  std::string names, cells;
  for (const RowField& field : rowFields) {
    names += std::string(field.key) + ";";
    cells += field.flag ? "yes;" : isAngle(field) ? "12 00 00;" : isFreeText(field) ? "said;" : "2;";
  }
  const Result<Import> import = importReadings(names + "\n" + cells + "\n");
  ASSERT_TRUE(import);
  EXPECT_THAT(import->problems, IsEmpty());
  const Reading& row = import->session.positions.at(0).readings.at(0);
  for (const RowField& field : rowFields) {
    if (field.flag)
      EXPECT_TRUE(row.*field.flag) << field.key;
    else
      EXPECT_EQ(row.*field.text, isAngle(field) ? "12 00 00" : isFreeText(field) ? "said" : "2") << field.key;
  }
}

// Each word names one column, and the name in the file is one of them.
TEST(RowFields, AreToldApartByTheirHeadings) {
  std::set<std::string> known{"axis", "position", "pos", "axisposition", "rotation"};
  for (const RowField& field : rowFields) {
    std::istringstream words{std::string(field.headings)};
    std::set<std::string> own;
    for (std::string word; words >> word;) {
      EXPECT_TRUE(known.insert(word).second) << word;
      own.insert(word);
    }
    EXPECT_TRUE(own.contains(std::string(field.key))) << field.key;
  }
}

TEST(RowFields, KnowWhatAnEmptyTextStandsFor) {
  EXPECT_EQ(usualText(rowField(&Reading::round)), "1");
  EXPECT_EQ(usualText(rowField(&Reading::face)), "1");
  for (const auto text : {&Reading::point, &Reading::horizontal, &Reading::slider, &Reading::note})
    EXPECT_EQ(usualText(rowField(text)), "");
}

// Excluding a row is nothing typed in it; each text is.
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
