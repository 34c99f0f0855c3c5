#include "core/answers/json_text.h"

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/version.h"

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, OfAnAnswerNamesTheProgramLast) {
  const Json answer = Json::parse(answerText({{"list", {1, 2}}}));
  EXPECT_EQ(answer.at("list").size(), 2U);
  const Json program = {{"name", "Alidade"}, {"version", programVersion}, {"build", programBuild}};
  EXPECT_EQ(std::prev(answer.end()).key(), "program");
  EXPECT_EQ(answer.at("program"), program);
}

// A file name of another coding, and a number that no reading determines.
TEST(JsonText, IsJsonWhateverItsValues) {
  const std::string text =
      answerText({{"name", "\xff"}, {"nothing", std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_EQ(text.find("{\n  \"name\": \"\uFFFD\",\n  \"nothing\": null,\n"), 0U) << text;
  EXPECT_EQ(text.back(), '\n');
}

}  // namespace
}  // namespace alidade
