#include "tests/console/console.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

// Properties of every call of the program: help, version, working folder, output.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Console, ExplainsItself) {
  const ProgramRun help = alidadeCli({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.out, HasSubstr("fit"));
  EXPECT_EQ(help.err, "");
  const ProgramRun fitHelp = alidadeCli({"fit", "--help"});
  EXPECT_EQ(fitHelp.exitCode, 0);
  EXPECT_THAT(fitHelp.out, HasSubstr("--method"));
  const ProgramRun version = alidadeCli({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  const auto program = nlohmann::json::parse(alidadeCli({"fit", paperSession, "--json"}).out).at("program");
  EXPECT_EQ(version.out, "alidade-cli " + program.at("version").get<std::string>() + " (" +
                             program.at("build").get<std::string>() + ")\n");
}

TEST(Console, WritesTheSameInEveryLocale) {
  const ProgramRun here = alidadeCli({"fit", paperSession});
  for (const char* locale : {"C", "C.UTF-8", "de_DE.UTF-8"}) {
    const ProgramRun there = runProgram({.program = ALIDADE_CLI,
                                         .arguments = {"fit", paperSession},
                                         .environment = {{"LC_ALL", locale}, {"LANG", locale}}});
    EXPECT_EQ(there.exitCode, 0) << locale;
    EXPECT_EQ(there.out, here.out) << locale;
  }
}

TEST(Console, TakesFilesRelativeToWhereItIsCalled) {
  const std::filesystem::path sample(paperSession);
  const ProgramRun run = runProgram({.program = ALIDADE_CLI,
                                     .arguments = {"fit", sample.filename().string()},
                                     .directory = sample.parent_path().string()});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.out, alidadeCli({"fit", paperSession}).out);
}

TEST(Console, ReadsStandardInputForADash) {
  std::ostringstream session;
  session << std::ifstream(paperSession).rdbuf();
  const ProgramRun run =
      runProgram({.program = ALIDADE_CLI, .arguments = {"fit", "-"}, .input = session.str()});
  EXPECT_EQ(run.out, alidadeCli({"fit", paperSession}).out);
  const ProgramRun bad = runProgram({.program = ALIDADE_CLI, .arguments = {"fit", "-"}, .input = "{"});
  expectRefusal(bad);
  EXPECT_THAT(bad.err, StartsWith("standard input: "));
}

TEST(Console, FailsWhereTheResultCannotBeWritten) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"fit", paperSession}, {"fit", paperSession, "--json"}, {"--help"}}) {
    const ProgramRun run =
        runProgram({.program = ALIDADE_CLI, .arguments = arguments, .outputFile = "/dev/full"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("could not be written"));
  }
}

}  // namespace
}  // namespace alidade::test
