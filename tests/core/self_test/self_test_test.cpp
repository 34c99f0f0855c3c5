#include "core/self_test/self_test.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/sha256.h"
#include "core/self_test/check_families.h"
#include "core/self_test/self_test_words.h"
#include "tests/support/file_content.h"
#include "tests/support/temporary_folder.h"

namespace alidade {
namespace {

using Json = nlohmann::json;

std::vector<std::string> failedLines(const std::vector<SelfCheck>& checks) {
  std::vector<std::string> names;
  for (const SelfCheck& check : checks)
    if (check.outcome == SelfCheck::Outcome::Failed) names.push_back(check.name);
  return names;
}

TEST(SelfTest, PassesHere) {
  const SelfTest test = runSelfTest({});
  EXPECT_EQ(failedLines(test.checks), std::vector<std::string>());
  EXPECT_TRUE(test.hasPassed());
  EXPECT_EQ(test.count(SelfCheck::Outcome::LeftOut), 1U);  // the program is not installed
  EXPECT_GE(test.count(SelfCheck::Outcome::Passed), 200U);
  for (const SelfCheck& check : test.checks) {
    EXPECT_STRNE(check.reason, "") << check.name;
    EXPECT_EQ(check.deviation.has_value(), check.tolerance.has_value()) << check.name;
  }
}

TEST(SelfTest, HoldsThirtyDigitsOfEveryFit) {
  for (const SelfCheck& check : fitChecks(compiledReferences().fits))
    EXPECT_GE(std::ranges::count_if(check.expected, [](char c) { return c >= '0' && c <= '9'; }), 30)
        << check.name << " " << check.expected;
}

// Every reference number is used: changing any of them by a hundred thousandth, or in its last letter, makes
// exactly its own line fail.
TEST(SelfTest, EveryReferenceThatIsWrongFailsInItsLine) {
  const Json whole = Json::parse(compiledReferences().fits);
  int spoilt = 0;
  for (std::size_t i = 0; i < whole.size(); i += 5) {
    for (const char* key : {"x", "y", "radius", "sigma_radius", "chi_square"}) {
      Json wrong = whole;
      Json& arc = wrong[i]["arcs"][0];
      const std::string was = arc[key].get<std::string>();
      arc[key] = std::to_string(std::stod(was) * (1 + 1e-4));
      const std::vector<std::string> failed = failedLines(fitChecks(wrong.dump()));
      ASSERT_EQ(failed.size(), 1U) << whole[i]["name"] << " " << key;
      EXPECT_EQ(failed[0].find(whole[i]["name"].get<std::string>() + ", 0°: "), 0U) << failed[0];
      ++spoilt;
    }
  }
  EXPECT_EQ(spoilt, 20);
}

TEST(SelfTest, FindsAReferenceThatIsWrongInTheEleventhDigit) {
  Json wrong = Json::parse(compiledReferences().fits);
  ASSERT_EQ(wrong[0]["intersection"].get<std::string>().substr(0, 12), "1.3078182569");
  wrong[0]["intersection"] = "1.3078182669992802395610";  // 1e-8 mm off, ten times what is allowed
  SelfTestReferences references = compiledReferences();
  references.fits = wrong.dump();
  const SelfTest test = runSelfTest({}, references);
  EXPECT_EQ(failedLines(test.checks), std::vector<std::string>{"table-1: Δd (mm)"});
  EXPECT_FALSE(test.hasPassed());
  EXPECT_NE(verdictSentence(test).find("does not pass: 1 of"), std::string::npos);
  EXPECT_EQ(Json::parse(selfTestJson(test, "t")).at("verdict"), "fail");
}

TEST(SelfTest, EveryNumberThatIsWrongFailsInItsLine) {
  const Json whole = Json::parse(compiledReferences().numbers);
  const auto spoil = [&](const std::string& pointer, const std::string& value, const std::string& line) {
    Json wrong = whole;
    wrong.at(Json::json_pointer(pointer)) = value;
    std::vector<SelfCheck> checks = distributionChecks(wrong.dump());
    for (const auto& family : {angleChecks(wrong.dump()), randomChecks(wrong.dump())})
      checks.insert(checks.end(), family.begin(), family.end());
    EXPECT_EQ(failedLines(checks), std::vector<std::string>{line});
  };
  spoil("/distributions/1/value", "2.2281388529", "t(0.95; 10)");
  spoil("/distributions/8/value", "0.05039700500", "chi2(41.3; 28)");
  spoil("/distributions/11/value", "0.0593177532", "F(1.75; 32; 32)");
  spoil("/angles/0/radians", "5.96681529143476", "341°52'24\" (rad)");
  spoil("/random/0/bits/1", "8c202a1a1dd3b94c", "seed 42, stream 7: bits 2");
  spoil("/random/1/normal/2", "2.13486627813805", "seed 1, stream 0: normal 3");
  spoil("/simulated/sha256", std::string(64, '0'), "simulate, seed 20261125: all");
}

TEST(SelfTest, ReferencesThatAreNoneFailWithTheReason) {
  for (const std::string text : {"", "{", "[{}]", "{\"distributions\": 3}"}) {
    EXPECT_FALSE(failedLines(fitChecks(text)).empty());
    EXPECT_FALSE(failedLines(distributionChecks(text)).empty());
    EXPECT_FALSE(failedLines(angleChecks(text)).empty());
    EXPECT_FALSE(failedLines(randomChecks(text)).empty());
  }
  EXPECT_FALSE(SelfTest().hasPassed());
}

TEST(SelfTest, ANumberThatIsNoneFails) {
  const CheckTolerance any{.absolute = 1e300, .relative = 1e300, .reason = "r"};
  EXPECT_EQ(numberCheck(CheckGroup::Fits, "n", "1", std::nan(""), any).outcome, SelfCheck::Outcome::Failed);
  EXPECT_EQ(numberCheck(CheckGroup::Fits, "n", "", 1, any).outcome, SelfCheck::Outcome::Failed);
  EXPECT_EQ(numberCheck(CheckGroup::Fits, "n", "1", 1, any).outcome, SelfCheck::Outcome::Passed);
}

TEST(SelfTest, ComparesTheInstalledFiles) {
  const test::TemporaryFolder folder;
  const std::filesystem::path share(folder.path());
  const auto from = [](const std::string& path) {
    const std::string samples = "alidade/samples/";
    if (path.starts_with(samples))
      return std::string(ALIDADE_SAMPLES_DIR) + "/" + path.substr(samples.size());
    return std::string(ALIDADE_SAMPLES_DIR) + "/../resources/help/" +
           path.substr(std::string("doc/alidade/help/").size());
  };
  for (const InstalledFile& file : installedFiles()) {
    const std::filesystem::path to = share / std::string(file.path);
    std::filesystem::create_directories(to.parent_path());
    std::filesystem::copy_file(from(std::string(file.path)), to);
  }
  EXPECT_EQ(failedLines(installedChecks(share.string())), std::vector<std::string>());
  EXPECT_GE(installedChecks(share.string()).size(), 40U);
  std::ofstream(share / "alidade/samples/two-faces.alidade", std::ios::app) << " ";
  std::filesystem::remove(share / "doc/alidade/help/en/gap.html");
  EXPECT_EQ(failedLines(installedChecks(share.string())),
            (std::vector<std::string>{"alidade/samples/two-faces.alidade", "doc/alidade/help/en/gap.html"}));
}

}  // namespace
}  // namespace alidade
