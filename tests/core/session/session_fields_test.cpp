#include "core/session/session_fields.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/answers/schemas.h"
#include "core/session/session_file.h"

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

/// The schema of the session file.
Json sessionSchema() {
  const auto schemas = answerSchemas();
  return Json::parse(std::ranges::find(schemas, "session", &AnswerSchema::name)->text);
}

const Json& propertiesOf(const Json& schema, std::string_view part) {
  return part.empty() ? schema["properties"] : schema["properties"][std::string(part)]["properties"];
}

TEST(SessionFields, StandInTheFileAtTheirKeys) {
  for (const SessionField& field : sessionFields()) {
    SCOPED_TRACE(field.key);
    Session session = blankSession();
    field.at(session) = "0.5";
    const Json file = Json::parse(writeSession(session));
    const Json& part = field.part().empty() ? file : file[std::string(field.part())];
    const Json half = field.kind() == ValueKind::Number ? Json(0.5) : Json("0.5");
    EXPECT_EQ(part.at(std::string(field.name())), half);
    EXPECT_EQ(sessionFieldNamed(field.key), &field);
  }
}

TEST(SessionFields, AreTextsOfTheirOwn) {
  Session session;
  std::set<const std::string*> texts;
  for (const SessionField& field : sessionFields()) {
    EXPECT_EQ(&field.at(session), &field.get(session)) << field.key;
    EXPECT_TRUE(texts.insert(&field.get(session)).second) << field.key;
  }
}

// In both directions: every text and number that the schema knows is a field.
TEST(SessionFields, AreThoseOfTheSchema) {
  const Json schema = sessionSchema();
  std::set<std::string> known, described;
  for (const SessionField& field : sessionFields()) known.insert(std::string(field.key));
  for (const std::string part :
       {"", "report", "device", "instrument", "environment", "geometry", "acceptance", "model"})
    for (const auto& [name, property] : propertiesOf(schema, part).items())
      if (property.value("type", Json()) == "string" ||
          property.value("type", Json()) == Json{"number", "string"})
        described.insert(part.empty() ? name : part + "." + name);
  EXPECT_EQ(known, described);
}

TEST(SessionFields, OfAFormHaveACaption) {
  std::set<std::string_view> shown;
  for (const auto& form : {measurementForm, instrumentForm, laboratoryForm, sessionForm})
    for (const std::string_view key : form) {
      const SessionField* field = sessionFieldNamed(key);
      ASSERT_TRUE(field) << key;
      EXPECT_TRUE(field->caption) << key;
      EXPECT_TRUE(shown.insert(key).second) << key;
    }
  for (const SessionField& field : sessionFields())
    EXPECT_EQ(shown.contains(field.key), field.caption != nullptr) << field.key;
}

TEST(SessionFields, TakeANumberWithItsUnit) {
  const auto text = [](const char* key, const char* typed) {
    return withoutUnit(*sessionFieldNamed(key), typed);
  };
  EXPECT_EQ(text("geometry.radius_mm", "400 mm"), "400");
  EXPECT_EQ(text("geometry.radius_mm", "400,50mm"), "400,50");
  EXPECT_EQ(text("instrument.sigma_horizontal_arcsec", "2.0 ″"), "2.0");
  EXPECT_EQ(text("environment.temperature_c", "-3.5 °C"), "-3.5");
  EXPECT_EQ(text("geometry.radius_mm", "0.4 m"), "0.4 m") << "another unit is not this number";
  EXPECT_EQ(text("geometry.radius_mm", "4OO mm"), "4OO mm") << "what is no number stays as typed";
  EXPECT_EQ(text("geometry.radius_mm", "mm"), "mm");
  EXPECT_EQ(text("title", "400 mm"), "400 mm") << "a text";
}

// The rules refuse nonsense where they know numbers and words.
TEST(SessionFields, AreCheckedByTheirRules) {
  for (const SessionField& field : sessionFields())
    EXPECT_EQ(entryProblem(field, "nonsense").has_value(), !std::holds_alternative<FreeText>(field.rule))
        << field.key;
}

}  // namespace
}  // namespace alidade
