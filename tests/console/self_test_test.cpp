#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/self_test/references.h"
#include "tests/console/console.h"

// `alidade-cli self-test`: a check of the installation, for filing.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(SelfTestCommand, PrintsEveryLineAndPasses) {
  const ProgramRun run = alidadeCli({"self-test"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, ContainsRegex("passed  table-1: Δd .mm. +1.3078182569992802395609637"));
  EXPECT_THAT(run.out, HasSubstr("[1] 1e-9 mm, a millionth of the smallest uncertainty"));
  EXPECT_THAT(run.out, HasSubstr("program: alidade-cli "));
  EXPECT_THAT(run.out, HasSubstr("Eigen: "));
  EXPECT_THAT(run.out, HasSubstr("processor: "));
  EXPECT_THAT(run.out, Not(HasSubstr("failed  ")));
  EXPECT_THAT(run.out, HasSubstr("This installation passes: all "));
}

TEST(SelfTestCommand, SaysTheSameToPrograms) {
  const ProgramRun run = alidadeCli({"self-test", "--json"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  const Json document = Json::parse(run.out);
  EXPECT_EQ(document.at("verdict"), "pass");
  EXPECT_EQ(document.at("failed"), 0);
  EXPECT_EQ(document.at("left_out"), 1);
  EXPECT_EQ(document.at("passed"), document.at("checks").size() - 1);
  EXPECT_TRUE(document.at("environment").contains("Boost"));
}

TEST(SelfTestCommand, FailsWithTheLineOfAReferenceThatIsOff) {
  Json fits = Json::parse(compiledReferences().fits);
  fits.at(3).at("arcs").at(1).at("y") = "0.442850264968";  // changed by 1e-8 mm
  const TemporaryFolder folder;
  const std::string path = folder.file("fits.json", fits.dump());
  const ProgramRun run = alidadeCli({"self-test", "--fits", path});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.out, ContainsRegex("failed  five-points, 180°: Δy .mm. +0.442850264968"));
  EXPECT_THAT(run.out, HasSubstr("This installation does not pass: 1 of "));
  const Json document = Json::parse(alidadeCli({"self-test", "--json", "--fits", path}).out);
  EXPECT_EQ(document.at("verdict"), "fail");
  EXPECT_EQ(document.at("failed"), 1);
}

TEST(SelfTestCommand, RefusesReferencesThatCannotBeRead) {
  expectRefusal(alidadeCli({"self-test", "--fits", "no-such-file"}));
  expectRefusal(alidadeCli({"self-test", "--numbers", "no-such-file"}));
  expectRefusal(alidadeCli({"self-test", "--frobnicate"}));
}

// An installed program with a changed sample fails, and nothing else fails.
TEST(SelfTestCommand, LooksAtWhatIsInstalledBesideIt) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const fs::path program = folder.path() / "bin/alidade-cli", share = folder.path() / "share";
  fs::create_directories(program.parent_path());
  fs::create_directories(share / "doc/alidade");
  fs::create_directories(share / "alidade");
  fs::copy_file(ALIDADE_CLI, program);
  fs::copy(ALIDADE_SAMPLES_DIR, share / "alidade/samples",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  fs::copy(ALIDADE_SAMPLES_DIR "/../resources/help", share / "doc/alidade/help", fs::copy_options::recursive);
  const auto run = [&] { return runProgram({.program = program.string(), .arguments = {"self-test"}}); };
  const ProgramRun sound = run();
  EXPECT_EQ(sound.exitCode, 0) << sound.out;
  EXPECT_THAT(sound.out, HasSubstr("passed  alidade/samples/two-faces.alidade"));
  fs::remove(share / "alidade/samples/two-faces.alidade");
  const ProgramRun spoilt = run();
  EXPECT_EQ(spoilt.exitCode, 1);
  EXPECT_THAT(spoilt.out, HasSubstr("failed  alidade/samples/two-faces.alidade"));
  EXPECT_THAT(spoilt.out, HasSubstr("does not pass: 1 of "));
}

}  // namespace
}  // namespace alidade::test
