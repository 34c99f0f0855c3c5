#include "core/session/json_origin.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonOrigin, GivesBackTheObjectAsItWasRead) {
  const std::string text = R"({"z":1.0,"a":{"c":null,"b":[]},"":"x"})";
  Json json = Json::parse(text);
  const JsonOrigin origin(json);
  json["a"] = 2;
  json.erase("z");
  EXPECT_EQ(origin.object().dump(), text);
}

TEST(JsonOrigin, OfNothingReadIsAnEmptyObject) {
  const JsonOrigin none;
  EXPECT_EQ(none.object(), Json::object());
  EXPECT_EQ(JsonOrigin(Json::object()).object(), Json::object());
}

// Rows share their common part, whose memory is many times that of a text.
TEST(JsonOrigin, IsSharedByItsCopiesAndOutlivedByThem) {
  std::optional<JsonOrigin> first(Json{{"k", 1}});
  const JsonOrigin copy = *first;
  EXPECT_EQ(&copy.object(), &first->object());
  first.reset();
  EXPECT_EQ(copy.object().dump(), R"({"k":1})");
}

TEST(JsonOrigin, MakesNoDifference) {
  EXPECT_EQ(JsonOrigin(Json{{"k", 1}}), JsonOrigin(Json{{"k", 2}}));
  EXPECT_EQ(JsonOrigin(Json{{"k", 1}}), JsonOrigin());
}

}  // namespace
}  // namespace alidade
