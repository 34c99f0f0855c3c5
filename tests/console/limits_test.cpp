#include <gmock/gmock.h>

#include "core/base/limits.h"
#include "tests/console/console.h"
#include "tests/support/guarded_memory.h"

// Excessive input of any kind gets an error message; large input takes time and memory in proportion.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

const std::string cli = "\"$0\"";  // the program in a shell command

/// Runs a shell command, since shells support devices.
ProgramRun shell(const std::string& line) {
  return runProgram({.program = "/bin/sh", .arguments = {"-c", line, ALIDADE_CLI}});
}

/// The start of such a command: limits of memory, and optionally of processor time. A sanitizer has its own
/// memory and time.
std::string within([[maybe_unused]] int megabytes, [[maybe_unused]] int seconds = 0) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  return "";
#else
  const std::string time = seconds > 0 ? "ulimit -t " + std::to_string(seconds) + "; " : "";
  return time + "ulimit -v " + std::to_string(1000 * megabytes) + "; ";
#endif
}

TEST(Limits, HoldForStandardInputToo) {
  for (const char* call : {" fit - < /dev/zero", " diagnose - < /dev/zero", " fit /dev/zero",
                           " import - --out x.alidade < /dev/zero"}) {
    const ProgramRun run = shell(within(2500) + cli + call);
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr(": is larger than 512 MiB: choose another file")) << call;
  }
}

TEST(Limits, EndALineOfATableThatGoesOnForEver) {
  const ProgramRun run =
      shell(within(1000) + "yes 1, | head -c 50000000 | tr -d '\\n' | " + cli + " import - --out x.alidade");
  expectRefusal(run);
  EXPECT_THAT(run.err, StartsWith("standard input: line 1, column 2001: has more than 1,000 columns"));
}

TEST(Limits, EndAFileOfNothingButBrackets) {
  const ProgramRun run =
      shell(within(1000) + "(printf '{\"x\": ['; yes '[],' | head -c 50000000) | " + cli + " fit -");
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("holds more than 1,000,000 values"));
}

// A quadratic algorithm would take a minute of processor time, which is independent of other load.
TEST(Load, FitOfManyRowsTakesTimeAndRoomInProportion) {
  const TemporaryFolder folder;
  const std::string session = folder.file("many.alidade", ""), truth = folder.file("truth.json", "");
  const ProgramRun made = alidadeCli({"simulate", "--out", session, "--truth", truth, "--points", "50000",
                                      "--rounds", "3", "--protocol", "paper"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  const ProgramRun run = shell(within(1500, 25) + "exec " + cli + " fit --json " + session);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["arcs"][1]["readings"], 150000);
}

TEST(Load, PlanOfManyRowsTakesTimeAndRoomInProportion) {
  const TemporaryFolder folder;
  const std::string session = folder.file("many.alidade", ""), truth = folder.file("truth.json", "");
  const ProgramRun made = alidadeCli(
      {"simulate", "--out", session, "--truth", truth, "--points", "20000", "--protocol", "paper"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  const ProgramRun run = shell(within(1500, 15) + "exec " + cli + " plan --json " + session);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["readings"], 80000);
}

TEST(FileName, OfAnyBytesStandsInTheResult) {
  const TemporaryFolder folder;
  const std::string named = changedPaperSession([](Json& session) { session["title"] = ""; });
  const std::string file = folder.file("caf\xE9.alidade", named);
  for (const char* command : {"fit", "diagnose", "plan"}) {
    const ProgramRun run = alidadeCli({command, file, "--json"});
    ASSERT_EQ(run.exitCode, 0) << command << ": " << run.err;
    EXPECT_EQ(Json::parse(run.out)["session"], "caf\\xe9.alidade");
  }
}

TEST(Trial, ScoresNoFolderWithoutAName) {
  const ProgramRun run = alidadeCli({"trial", "--score", ""});
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("--score is given an empty value"));
}

}  // namespace
}  // namespace alidade::test
