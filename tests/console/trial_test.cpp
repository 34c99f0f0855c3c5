#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/console/console.h"

// `alidade-cli trial`: blind trials drawn here, or made elsewhere and scored.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::string stored = ALIDADE_REFERENCE_DIR "/trials";

TEST(Trial, ScoresDrawnTrials) {
  const std::vector<std::string> call{"trial", "--count",    "8",     "--seed",
                                      "3",     "--protocol", "paper", "--json"};
  const ProgramRun run = alidadeCli(call);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json answer = Json::parse(run.out);
  EXPECT_EQ(answer.at("count"), 8);
  ASSERT_EQ(answer.at("trials").size(), 8u);
  EXPECT_EQ(answer.at("trials").at(0).at("id"), "3");
  for (const char* key : {"right", "false_alarms", "covered", "back_to_noise", "detection", "confusion"})
    EXPECT_TRUE(answer.contains(key)) << key;
  for (const Json& trial : answer.at("trials")) EXPECT_EQ(trial.at("protocol"), "paper");
  std::vector<std::string> serial = call;
  serial.insert(serial.end(), {"--threads", "1"});
  EXPECT_EQ(alidadeCli(serial).out, run.out);
}

/// Copies some of the stored trials into a new set.
void keep(const std::filesystem::path& folder, const std::vector<std::string>& ids) {
  std::ifstream file(stored + "/truth.json");
  const Json all = Json::parse(file);
  Json some;
  std::filesystem::create_directories(folder / "sessions");
  for (const std::string& id : ids) {
    some[id] = all.at(id);
    std::filesystem::copy(stored + "/sessions/" + id + ".alidade", folder / "sessions" / (id + ".alidade"));
  }
  std::ofstream(folder / "truth.json") << some;
}

TEST(Trial, ScoresTrialsMadeElsewhere) {
  const TemporaryFolder folder;
  keep(folder.path(), {"241926", "827247", "825912"});  // collimation, none, gross_error
  const ProgramRun run = alidadeCli({"trial", "--score", folder.path().string(), "--withheld", "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json answer = Json::parse(run.out);
  EXPECT_EQ(answer.at("right").at("look-alikes"), Json({{"hits", 1}, {"count", 1}}));
  EXPECT_EQ(answer.at("right").at("none"), Json({{"hits", 1}, {"count", 1}}));
  EXPECT_EQ(answer.at("right").at("gross_error"), Json({{"hits", 1}, {"count", 1}}));
  EXPECT_EQ(answer.at("wrong_without"), Json({{"hits", 0}, {"count", 1}}));
  const ProgramRun text = alidadeCli({"trial", "--score", folder.path().string()});
  EXPECT_THAT(text.out, HasSubstr("3 blind trials"));
  EXPECT_THAT(text.out, HasSubstr("look-alikes"));
}

constexpr const char* dent = R"json({
  "format": "alidade-effect", "version": 1, "id": "dent", "owner": {"device": "G-7"},
  "formula": "radial = A*bump(s, 83°, 8°)", "parameters": [{"name": "A", "plausible": 0.2, "unit": "mm"}]
})json";

// With some 36 kinds, 60 drawn trials include the own effect with probability 0.8; with this seed they do.
TEST(Trial, DrawsOwnEffects) {
  const TemporaryFolder folder;
  const std::string effect = folder.file("dent.alidade-effect", dent);
  const ProgramRun run = alidadeCli(
      {"trial", "--count", "60", "--seed", "1", "--protocol", "full", "--effects", effect, "--json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Json answer = Json::parse(run.out);
  std::size_t drawn = 0;
  for (const Json& trial : answer.at("trials")) drawn += trial.at("kind") == "own:dent" ? 1 : 0;
  EXPECT_GT(drawn, 0u);
  EXPECT_EQ(answer.at("kinds").at("own:dent").at("right").at("count"), drawn);
  EXPECT_GT(answer.at("kinds").at("own:dent").at("right").at("hits"), 0);
}

// Sessions of another program do not define the effect, so the diagnosis knows it only from its file.
TEST(Trial, ScoresStoredOwnEffects) {
  const TemporaryFolder folder;
  const std::string effect = folder.file("dent.alidade-effect", dent);
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  const ProgramRun made =
      alidadeCli({"simulate", "--out", path("s.alidade"), "--truth", path("truth.json"), "--protocol", "full",
                  "--device-serial", "G-7", "--effects", effect, "--effect", "own:dent=0.3"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  const auto rightOf = [&](std::vector<std::string> more) {
    std::vector<std::string> call{"trial", "--score", folder.path().string(), "--json"};
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun run = alidadeCli(call);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return Json::parse(run.out).at("right");
  };
  const Json once = {{"hits", 1}, {"count", 1}};
  EXPECT_EQ(rightOf({}), Json({{"unknown", once}}));
  EXPECT_EQ(rightOf({"--effects", effect}), Json({{"others", once}}));
}

TEST(Trial, RefusesInOneLine) {
  const auto refusal = [](std::vector<std::string> call) {
    call.insert(call.begin(), "trial");
    const ProgramRun run = alidadeCli(call);
    expectRefusal(run);
    return run.err;
  };
  EXPECT_THAT(refusal({"--score", "/no/such/folder"}), HasSubstr("/no/such/folder/truth.json"));
  EXPECT_THAT(refusal({"--protocol", "by-ear"}), HasSubstr("by-ear"));
  EXPECT_THAT(refusal({"--count", "0"}), HasSubstr("--count"));
  EXPECT_THAT(refusal({"--score", stored, "--count", "5"}), HasSubstr("--count"));
  EXPECT_THAT(refusal({"--series", "2", "--effects", "dent.alidade-effect"}), HasSubstr("--effects"));
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "truth.json") << "{}";
  EXPECT_THAT(refusal({"--score", folder.path().string()}), HasSubstr("nothing to score"));
  std::ofstream(folder.path() / "truth.json") << R"({"nobody": {"kind": "none", "intersection_mm": 0}})";
  EXPECT_THAT(refusal({"--score", folder.path().string()}), HasSubstr("nobody.alidade"));
  std::ofstream(folder.path() / "truth.json") << R"({"nobody": {"kind": "none"}})";
  EXPECT_THAT(refusal({"--score", folder.path().string()}), HasSubstr("intersection_mm"));
}

TEST(Trial, ReadsByWhatEachSightingTells) {
  const std::vector<std::string> call{"trial",   "--adaptive", "--protocol", "two-face",
                                      "--count", "2",          "--clean",    "1",
                                      "--seed",  "1",          "--json",     "--threads"};
  const auto on = [&](const char* threads) {
    std::vector<std::string> all = call;
    all.emplace_back(threads);
    return alidadeCli(all);
  };
  const ProgramRun run = on("1");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(on("2").out, run.out);
  const Json answer = Json::parse(run.out);
  ASSERT_EQ(answer.at("trials").size(), 2u);
  EXPECT_EQ(answer.at("trials").at(0).at("rows"), 136);
  EXPECT_LT(answer.at("trials").at(0).at("by_worth").at("sightings"), 68);
  ASSERT_EQ(answer.at("clean").size(), 1u);
  EXPECT_EQ(answer.at("clean").at(0).at("sightings"), 136);
  EXPECT_EQ(answer.at("clean").at(0).at("named"), Json::array());
  EXPECT_NE(alidadeCli({"trial", "--adaptive"}).exitCode, 0);
}

TEST(Trial, DrawsTheCurvesOfBothWays) {
  const ProgramRun run = alidadeCli({"trial", "--adaptive", "--protocol", "two-face", "--count", "2",
                                     "--clean", "1", "--seed", "1", "--csv"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, testing::StartsWith("kind,way,against,at,right_percent,wrong_percent,expanded_mm\n"));
  EXPECT_THAT(run.out, HasSubstr("\nall,by_worth,sightings,136,100.0,0.0,\n"));
  EXPECT_THAT(run.out, HasSubstr("\nnone,in_order,sightings,136,,,0."));
  EXPECT_NE(alidadeCli({"trial", "--csv"}).exitCode, 0);
}

}  // namespace
}  // namespace alidade::test
