#include "core/session/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
  EXPECT_THAT(sentenceOn("{} {}"), HasSubstr("goes on after its end, at line 1, column 4"));
  EXPECT_THAT(sentenceOn("{\"a\": [1]}\n]"), HasSubstr("goes on after its end, at line 2, column 1"));
  EXPECT_THAT(sentenceOn("{\"a\": NaN}"), HasSubstr("line 1"));
}

TEST(JsonText, NamesWhatElseIsWrongWithATextAndWhatToDo) {
  EXPECT_THAT(sentenceOn(""), HasSubstr("is empty: choose a session file"));
  EXPECT_THAT(sentenceOn(" \n"), HasSubstr("is empty"));
  EXPECT_THAT(sentenceOn("{\"a\": [1, 2"),
              HasSubstr("ends too early, at line 1, column 12: the file is cut short"));
  EXPECT_THAT(sentenceOn("{\"a\": \"\xFF\"}"), HasSubstr("is not UTF-8 text at line 1, column 8"));
  EXPECT_THAT(sentenceOn("{\"a\": 1e999}"), HasSubstr("has a number too large"));
  EXPECT_THAT(sentenceOn("{\"a\": \"\\ud800\"}"), HasSubstr("is not JSON at line 1"));
}

TEST(JsonText, RefusesAKeyThatStandsTwiceWithItsPlace) {
  EXPECT_THAT(sentenceOn(R"({"title": "a", "title": "b"})"), HasSubstr("title: stands twice in one object"));
  EXPECT_THAT(sentenceOn(R"({"positions": [{}, {"readings": [{}, {"vertical": 1, "vertical": 2}]}]})"),
              HasSubstr("positions[1].readings[1].vertical: stands twice"));
  EXPECT_THAT(sentenceOn(R"({"x": [[{"y": 1, "y": 1}]]})"), HasSubstr("x[0][0].y: stands twice"));
  EXPECT_EQ(sentenceOn(R"({"x": {"y": 1}, "y": {"y": 1}})"), "accepted");
}

TEST(JsonText, RefusesNestingThatWouldExhaustTheStack) {
  EXPECT_THAT(sentenceOn(std::string(100000, '[')), StartsWith("is nested more than 100 levels deep"));
  EXPECT_THAT(sentenceOn(R"({"title": "", "notes": )" + std::string(100000, '[')),
              StartsWith("notes: is nested more than 100 levels deep"));
  EXPECT_EQ(sentenceOn(std::string(100, '[') + std::string(100, ']')), "accepted");
}

TEST(JsonText, LaysOutReadingsAndPointingZeroOnOneLine) {
  const auto json = nlohmann::ordered_json::parse(
      R"({"a": {}, "b": [], "positions": [{"pointing_zero": {"x": 1}, "readings": [{"p": 1, "q": {"r": [2, "3"]}}, {}]}],
          "readings": [{"p": 1}]})");
  EXPECT_EQ(layoutJson(json),
            "{\n"
            "  \"a\": {},\n"
            "  \"b\": [],\n"
            "  \"positions\": [\n"
            "    {\n"
            "      \"pointing_zero\": {\"x\": 1},\n"
            "      \"readings\": [\n"
            "        {\"p\": 1, \"q\": {\"r\": [2, \"3\"]}},\n"
            "        {}\n"
            "      ]\n"
            "    }\n"
            "  ],\n"
            "  \"readings\": [\n"
            "    {\n"
            "      \"p\": 1\n"
            "    }\n"
            "  ]\n"
            "}\n");
}

}  // namespace
}  // namespace alidade
