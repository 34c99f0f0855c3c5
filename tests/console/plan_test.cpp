#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/console/console.h"

// `alidade-cli plan`: what a plan of readings can detect, before or after it is read.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

Json reviewOf(const std::string& file) {
  const ProgramRun run = alidadeCli({"plan", file, "--json"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return Json::parse(run.out);
}

TEST(Plan, ReviewsAPlanThatHasBeenRead) {
  const Json review = reviewOf(paperSession);
  EXPECT_EQ(review.at("session"), "Table I");
  EXPECT_EQ(review.at("readings"), 68);
  EXPECT_EQ(review.at("effects").size(), 23u);
  for (const Json& effect : review.at("effects"))
    for (const char* key : {"effect", "plausible", "visible_sigma", "look_alikes", "influence_mm", "unseen"})
      EXPECT_TRUE(effect.contains(key)) << key;
  EXPECT_FALSE(review.at("advice").empty());
  const Json& attainable = review.at("attainable");
  EXPECT_EQ(attainable.at(0).at("measure"), "");
  EXPECT_EQ(attainable.at(0).at("known"), "");
  for (std::size_t i = 1; i < attainable.size(); ++i)
    EXPECT_LT(attainable[i].at("expanded_mm"), attainable[0].at("expanded_mm"));
}

// Unread rows are spread over the same range as the paper's, so results are similar: 10 %, and 0.1 σ.
TEST(Plan, ReviewsAPlanThatHasNotBeenRead) {
  const TemporaryFolder folder;
  const auto unsight = [](Json& session) {
    for (auto& position : session["positions"])
      for (auto& reading : position["readings"]) reading["horizontal"] = reading["vertical"] = "";
  };
  const std::string file = folder.file("plan.alidade", changedPaperSession(unsight));
  const Json unread = reviewOf(file), read = reviewOf(paperSession);
  for (std::size_t i = 0; i < read.at("effects").size(); ++i) {
    const double expected = read["effects"][i]["visible_sigma"]["most"];
    EXPECT_NEAR(unread["effects"][i]["visible_sigma"]["most"].get<double>(), expected, 0.1 * expected + 0.1)
        << read["effects"][i]["effect"];
  }
  const double expanded = read["attainable"][0]["expanded_mm"];
  EXPECT_NEAR(unread["attainable"][0]["expanded_mm"].get<double>(), expanded, 0.1 * expanded);
}

TEST(Plan, SaysItInWordsToo) {
  const ProgramRun run = alidadeCli({"plan", paperSession});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("vertical drift"));
  EXPECT_THAT(run.out, HasSubstr("undetectable\n"));
  EXPECT_THAT(run.out, HasSubstr("Slider readings, both faces and a return run (in a new session)"));
  EXPECT_THAT(run.out, HasSubstr("\nTypical U for this plan: "));
  EXPECT_LT(run.out.find("What to measure next"), run.out.find("would show"));
}

// A plan without noise leaves some thousand degrees of freedom and residuals below one arcsecond.
TEST(Plan, ReviewsALargePlan) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "plan.alidade").string(), truth = (folder.path() / "t").string();
  ASSERT_EQ(
      alidadeCli({"simulate", "--out", file, "--truth", truth, "--points", "1000", "--rounds", "2"}).exitCode,
      0);
  EXPECT_EQ(reviewOf(file).at("readings"), 8000);
}

TEST(Plan, HasNoInfluenceOnAnIntersectionThatThereIsNot) {
  const TemporaryFolder folder;
  const auto only0 = [](Json& session) { session["positions"].erase(1); };
  const std::string file = folder.file("plan.alidade", changedPaperSession(only0));
  EXPECT_EQ(reviewOf(file)["effects"][0]["influence_mm"], nullptr);
  EXPECT_THAT(alidadeCli({"plan", file}).out, HasSubstr("none"));
}

TEST(Plan, RefusesInOneLine) {
  const ProgramRun missing = alidadeCli({"plan", "/no/such/file.alidade"});
  expectRefusal(missing);
  EXPECT_THAT(missing.err, HasSubstr("/no/such/file.alidade"));
  expectRefusal(alidadeCli({"plan"}));
}

}  // namespace
}  // namespace alidade::test
