#include "core/answers/json_text.h"

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/version.h"

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

const Json row = {{"name", "a\nb"}, {"size", 0.1}, {"nothing", std::numeric_limits<double>::quiet_NaN()}};

LongList rows(const char* path, std::size_t count) {
  return {path, count, [](std::size_t, const TakeMember& take) {
            for (const auto& [key, value] : row.items()) take(key.c_str(), value);
          }};
}

Json listOf(std::size_t count) {
  return Json(count, row);
}

Json document(const Json& list, const Json& inner) {
  return {{"title", "line\nbreak"},
          {"list", list},
          {"deep", {{"empty", Json::array()}, {"object", Json::object()}, {"inner", inner}, {"x", {1, 2}}}},
          {"last", nullptr}};
}

// The library's own text of a document with every kind of value.
TEST(JsonText, IsThatOfTheWholeDocumentWhateverIsWrittenLater) {
  for (const std::size_t count : {0, 1, 3})
    EXPECT_EQ(
        jsonText(document(Json::array(), Json::array()), {rows("/list", count), rows("/deep/inner", 2)}),
        document(listOf(count), listOf(2)).dump(2) + "\n");
}

TEST(JsonText, TakesADocumentWithoutLongLists) {
  EXPECT_EQ(jsonText(document(listOf(2), Json::array())), document(listOf(2), Json::array()).dump(2) + "\n");
  EXPECT_EQ(jsonText(Json::object()), "{}\n");
  EXPECT_EQ(jsonText("\xff"), "\"\uFFFD\"\n");
}

TEST(JsonText, OfAnAnswerNamesTheProgramLast) {
  const Json answer = Json::parse(answerText({{"list", Json::array()}}, {rows("/list", 2)}));
  EXPECT_EQ(answer.at("list").size(), 2U);
  const Json program = {{"name", "Alidade"}, {"version", programVersion}, {"build", programBuild}};
  EXPECT_EQ(std::prev(answer.end()).key(), "program");
  EXPECT_EQ(answer.at("program"), program);
}

}  // namespace
}  // namespace alidade
