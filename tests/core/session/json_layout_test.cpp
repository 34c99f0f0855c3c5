#include "core/session/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace alidade {
namespace {

TEST(JsonLayout, PutsReadingsAndPointingZeroOnOneLine) {
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

TEST(JsonLayout, AsksForRowsWhereThereIsTheirNumber) {
  const auto json = nlohmann::ordered_json::parse(
      R"({"readings": 7, "positions": [{"readings": 0}, {"readings": 2}, {"x": {"readings": 5}}]})");
  const auto rowOf = [](std::size_t position, std::size_t row) {
    return nlohmann::ordered_json{{"p", position}, {"r", row}};
  };
  nlohmann::ordered_json whole = json;
  whole["positions"][0]["readings"] = nlohmann::ordered_json::array();
  whole["positions"][1]["readings"] = {rowOf(1, 0), rowOf(1, 1)};
  EXPECT_EQ(layoutJson(json, rowOf), layoutJson(whole));
}

}  // namespace
}  // namespace alidade
