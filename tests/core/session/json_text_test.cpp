#include "core/session/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/limits.h"

namespace alidade {
namespace {

using testing::HasSubstr, testing::StartsWith;

std::string sentenceOn(std::string_view text) {
  nlohmann::ordered_json json;
  const auto problem = parseJson(text, json);
  return problem ? problem->text() : "accepted";
}

TEST(JsonText, ParsesLikeTheLibrary) {
  const char* text =
      R"({"b": [1, -2, 3.5, 1e3, true, null, {"x": {}}], "a": "\u00b0 \ud835\udefc \\ \n", "c": []})";
  nlohmann::ordered_json json;
  ASSERT_FALSE(parseJson(text, json));
  EXPECT_EQ(json, nlohmann::ordered_json::parse(text));
  EXPECT_EQ(json.begin().key(), "b") << "the order is kept";
}

TEST(JsonText, ToleratesAByteOrderMark) {
  nlohmann::ordered_json json;
  ASSERT_FALSE(parseJson("\xEF\xBB\xBF{\"a\": 1}", json));
  EXPECT_EQ(json["a"], 1);
}

TEST(JsonText, NamesLineAndColumnOfASyntaxError) {
  EXPECT_THAT(sentenceOn("{\n  \"a\": 1,\n  \"°\" 2\n}"), HasSubstr("is not JSON at line 3, column 7, at “"));
  EXPECT_THAT(sentenceOn("{\"a\": 1,}"), HasSubstr("line 1, column 9"));
  EXPECT_THAT(sentenceOn("{} {}"),
              HasSubstr("continues after the end of the JSON document, at line 1, column 4"));
  EXPECT_THAT(sentenceOn("{\"a\": [1]}\n]"),
              HasSubstr("continues after the end of the JSON document, at line 2, column 1"));
  EXPECT_THAT(sentenceOn("{\"a\": NaN}"), HasSubstr("line 1"));
}

TEST(JsonText, NamesWhatElseIsWrongWithATextAndWhatToDo) {
  EXPECT_THAT(sentenceOn(""), HasSubstr("is empty: choose another file"));
  EXPECT_THAT(sentenceOn(" \n"), HasSubstr("is empty"));
  EXPECT_THAT(sentenceOn("{\"a\": [1, 2"),
              HasSubstr("ends too early, at line 1, column 12: the file is incomplete"));
  EXPECT_THAT(sentenceOn("{\"a\": \"\xFF\"}"), HasSubstr("is not UTF-8 text at line 1, column 8"));
  EXPECT_THAT(sentenceOn("{\"a\": 1e999}"), HasSubstr("has too large a number"));
  EXPECT_THAT(sentenceOn("{\"a\": \"\\ud800\"}"), HasSubstr("is not JSON at line 1"));
}

TEST(JsonText, RefusesAKeyThatStandsTwiceWithItsPlace) {
  EXPECT_THAT(sentenceOn(R"({"title": "a", "title": "b"})"), HasSubstr("title: is a duplicate key"));
  EXPECT_THAT(sentenceOn(R"({"positions": [{}, {"readings": [{}, {"vertical": 1, "vertical": 2}]}]})"),
              HasSubstr("positions[1].readings[1].vertical: is a duplicate key"));
  EXPECT_THAT(sentenceOn(R"({"x": [[{"y": 1, "y": 1}]]})"), HasSubstr("x[0][0].y: is a duplicate key"));
  EXPECT_EQ(sentenceOn(R"({"x": {"y": 1}, "y": {"y": 1}})"), "accepted");
}

TEST(JsonText, RefusesNestingThatWouldExhaustTheStack) {
  EXPECT_THAT(sentenceOn(std::string(100000, '[')), StartsWith("is nested more than 100 levels deep"));
  EXPECT_THAT(sentenceOn(R"({"title": "", "notes": )" + std::string(100000, '[')),
              StartsWith("notes: is nested more than 100 levels deep"));
  EXPECT_EQ(sentenceOn(std::string(100, '[') + std::string(100, ']')), "accepted");
}

TEST(JsonText, RefusesMoreValuesThanAnySessionHasBesidesItsRows) {
  const auto listOf = [](std::size_t count) {
    std::string text = "[";
    for (std::size_t i = 1; i < count; ++i) text += i == 1 ? "1" : ",1";  // the list itself counts as one
    return text + "]";
  };
  EXPECT_EQ(sentenceOn(listOf(limits::mostValues)), "accepted");
  EXPECT_THAT(sentenceOn(listOf(limits::mostValues + 1)),
              HasSubstr("holds more than 1,000,000 values besides its rows"));
}

TEST(JsonText, DoesNotCountTheValuesOfRows) {
  constexpr std::size_t rows = 1000, values = 1500;
  std::string row = "{\"x\": [1";
  for (std::size_t i = 1; i < values; ++i) row += ",1";
  row += "]}";
  std::string text = R"({"positions": [{"readings": [)";
  for (std::size_t i = 0; i < rows; ++i) text += (i == 0 ? "" : ",") + row;
  nlohmann::ordered_json json;
  std::size_t taken = 0;
  const auto problem =
      parseJson(text + "]}]}", json, [&](const Place&, const nlohmann::ordered_json&) { ++taken; });
  EXPECT_FALSE(problem) << problem->text();
  EXPECT_EQ(taken, rows);
  EXPECT_THAT(sentenceOn(text + "]}]}"), HasSubstr("values besides"))
      << "they are kept where nobody takes them";
}

TEST(JsonText, RefusesTextsAndRowsBeyondTheLimits) {
  const std::string longest(limits::longestText, 'x');
  EXPECT_EQ(sentenceOn("{\"a\": \"" + longest + "\"}"), "accepted");
  EXPECT_THAT(sentenceOn("{\"a\": \"" + longest + "x\"}"), StartsWith("a: has a text of more than 1 MiB"));
  EXPECT_THAT(sentenceOn("{\"" + longest + "x\": 1}"), StartsWith("has a text of more than 1 MiB"));
  std::string text = R"({"positions": [{"readings": [0)";
  for (std::size_t i = 1; i < limits::mostRows; ++i) text += ",0";
  nlohmann::ordered_json json;
  const TakeRow take = [](const Place&, const nlohmann::ordered_json&) {};
  EXPECT_FALSE(parseJson(text + "]}]}", json, take));
  const auto problem = parseJson(text + "]}, {\"readings\": [0]}]}", json, take);
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->text(), StartsWith("holds more than 2,000,000 rows of readings"));
}

TEST(JsonText, HandsOnRowsOneByOneAndKeepsThemNoLonger) {
  nlohmann::ordered_json json;
  std::vector<std::string> rows;
  const auto take = [&](const Place& where, const nlohmann::ordered_json& row) {
    rows.push_back(where.path() + " " + row.dump());
  };
  ASSERT_FALSE(
      parseJson(R"({"readings": [1], "positions": [{"readings": [{"a": [[1]]}, 2]}, {"x": {"readings": [3]}},
                             {"readings": {"readings": [4]}}, {"readings": []}]})",
                json, take));
  EXPECT_EQ(rows, (std::vector<std::string>{"positions[0].readings[0] {\"a\":[[1]]}",
                                            "positions[0].readings[1] 2"}));
  EXPECT_EQ(
      json.dump(),
      R"({"readings":[1],"positions":[{"readings":[]},{"x":{"readings":[3]}},{"readings":{"readings":[4]}},{"readings":[]}]})");
}

TEST(JsonText, CountsRowsThatItKeepsNoLonger) {
  nlohmann::ordered_json json;
  const auto problem = parseJson(R"({"positions": [{}, {"readings": [{}, {}, {"a": 1, "a": 2}]}]})", json,
                                 [](const Place&, const nlohmann::ordered_json&) {});
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->text(), StartsWith("positions[1].readings[2].a: is a duplicate key"));
}

}  // namespace
}  // namespace alidade
