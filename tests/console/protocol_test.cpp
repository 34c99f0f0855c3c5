#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/console/console.h"

// `alidade-cli protocol`: a session led through its sightings.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

Json guidanceOf(const std::string& file, const std::string& protocol) {
  const ProgramRun run = alidadeCli({"protocol", file, "--template", protocol, "--json"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return Json::parse(run.out);
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ProtocolCommand, SaysWhatIsNextAndWhatIsLeft) {
  const Json guidance = guidanceOf(paperSession, "there-and-back");
  EXPECT_EQ(guidance.at("planned"), 70);
  EXPECT_EQ(guidance.at("taken"), 36);
  EXPECT_EQ(guidance.at("left"), 34);
  EXPECT_EQ(guidance.at("next").at("axis_deg"), 180);
  EXPECT_EQ(guidance.at("next").at("point"), 17);
  EXPECT_EQ(guidance.at("next").at("round"), 2);
  EXPECT_EQ(guidance.at("sightings").size(), 70u);
  // The return run visits a place read in round 1 as about 323°07'06".
  EXPECT_NEAR(guidance.at("next").at("expected").at("horizontal_deg").get<double>(), 323.118, 0.01);
  EXPECT_TRUE(guidance.at("repeat").is_array());
}

/// With twice the readings U of Δd, fit only, decreases to 1/√2 of it, except for zeros and distance, which
/// are small here.
TEST(ProtocolCommand, SaysWhatTheRestBrings) {
  const Json outlook = guidanceOf(paperSession, "there-and-back").at("outlook");
  const double now = outlook.at("now").at("of_fit_mm"),
               then = outlook.at("ahead").at(0).at("expanded").at("of_fit_mm");
  EXPECT_NEAR(now, 0.2112, 0.001) << "the README's 0.211 mm";
  EXPECT_NEAR(then, now / std::sqrt(2), 0.03 * now) << "and Student's factor is smaller";
  EXPECT_EQ(outlook.at("enough_now"), true);
  EXPECT_NEAR(outlook.at("needed").at("of_fit_mm").get<double>(), 2.5 - 1.30782, 1e-4);
  EXPECT_THAT(outlook.at("sentence").get<std::string>(), HasSubstr("The readings are enough"));
}

TEST(ProtocolCommand, NamesWhatIsToBeTakenAgain) {
  const ProgramRun run =
      alidadeCli({"protocol", ALIDADE_SAMPLES_DIR "/misreading.alidade", "--template", "rows"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Take again\n"));
  EXPECT_THAT(run.out, HasSubstr("point 5 again: its vertical reading"));
}

TEST(ProtocolCommand, KeepsTheProtocolInTheSessionAndAsATemplate) {
  const TemporaryFolder folder;
  const std::string session = (folder.path() / "led.alidade").string(),
                    saved = (folder.path() / "own.alidade-protocol").string();
  const ProgramRun made = alidadeCli(
      {"protocol", paperSession, "--template", "two-face", "--out", session, "--save-template", saved});
  EXPECT_EQ(made.exitCode, 0) << made.err;
  EXPECT_EQ(Json::parse(contentOf(saved)).at("format"), "alidade-protocol");
  const ProgramRun led = alidadeCli({"protocol", session, "--json"});
  EXPECT_EQ(led.exitCode, 0) << led.err;
  EXPECT_EQ(Json::parse(led.out).at("protocol"), "two-face");
  const auto answerOf = [](const ProgramRun& run) {
    Json answer = Json::parse(run.out);
    EXPECT_EQ(answer.erase("session_sha256"), 1u) << "the files differ";
    return answer.dump();
  };
  EXPECT_EQ(answerOf(led), answerOf(alidadeCli({"protocol", paperSession, "--template", saved, "--json"})));
  Json without = Json::parse(contentOf(session));
  without.erase("protocol");
  EXPECT_EQ(without.dump(), Json::parse(contentOf(paperSession)).dump()) << "nothing else has changed";
}

TEST(ProtocolCommand, FollowsWhatThePlanAdvises) {
  const Json guidance = guidanceOf(paperSession, "plan");
  EXPECT_GT(guidance.at("planned"), 36);
  EXPECT_GT(guidance.at("left"), 0);
}

TEST(ProtocolCommand, WritesNoFileOverTheTemplateThatItFollows) {
  const TemporaryFolder folder;
  const std::string saved = (folder.path() / "own.alidade-protocol").string();
  ASSERT_EQ(
      alidadeCli({"protocol", paperSession, "--template", "two-face", "--save-template", saved}).exitCode, 0);
  const std::string before = contentOf(saved);
  for (const char* option : {"--out", "--save-template"}) {
    const ProgramRun run = alidadeCli({"protocol", paperSession, "--template", saved, option, saved});
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr("this is the file being read"));
    EXPECT_EQ(contentOf(saved), before) << option;
  }
  const ProgramRun named =
      runProgram({.program = ALIDADE_CLI,
                  .arguments = {"protocol", paperSession, "--template", "full", "--out", "full"},
                  .directory = folder.path()});
  EXPECT_EQ(named.exitCode, 0) << named.err;
}

TEST(ProtocolCommand, RefusesWhatCannotBeFollowed) {
  const TemporaryFolder folder;
  expectRefusal(alidadeCli({"protocol", paperSession}));
  expectRefusal(alidadeCli({"protocol", paperSession, "--template", "no-such-protocol"}));
  const std::string wrong =
      folder.file("wrong.alidade-protocol",
                  R"({"format": "alidade-protocol", "version": 1, "positions": [{"axis_deg": 7}]})");
  const ProgramRun run = alidadeCli({"protocol", paperSession, "--template", wrong});
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("positions[0].axis_deg"));
}

}  // namespace
}  // namespace alidade::test
