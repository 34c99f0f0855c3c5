#include <gmock/gmock.h>
#include <sys/resource.h>

#include <utility>

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

/// Runs a shell command, which can redirect to devices and set limits.
ProgramRun shell(const std::string& line) {
  return runProgram({.program = "/bin/sh", .arguments = {"-c", line, ALIDADE_CLI}});
}

/// The start of a shell command that limits its memory. Empty under a sanitizer, which has its own limits.
std::string within([[maybe_unused]] int megabytes) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  return "";
#else
  return "ulimit -v " + std::to_string(1000 * megabytes) + "; ";
#endif
}

/// Seconds of processor time that the ended children of this process took.
double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Runs a command on a simulated session; returns the JSON of its answer and the processor time it took.
std::pair<Json, double> answerTo(const std::string& command, int points, const std::string& rounds) {
  const TemporaryFolder folder;
  const std::string session = folder.file("many.alidade", ""), truth = folder.file("truth.json", "");
  const ProgramRun made = alidadeCli({"simulate", "--out", session, "--truth", truth, "--points",
                                      std::to_string(points), "--rounds", rounds, "--protocol", "paper"});
  EXPECT_EQ(made.exitCode, 0) << made.err;
  const double before = processorSeconds();
  const ProgramRun run = shell(within(1000) + "exec " + cli + " " + command + " --json " + session);
  const double seconds = processorSeconds() - before;
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return {run.exitCode == 0 ? Json::parse(run.out) : Json(), seconds};
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

// Four times the rows take four times as long, or 16 times by a quadratic algorithm. The bound between them
// holds on a machine of any speed, however loaded.
TEST(Load, FitOfManyRowsTakesTimeAndRoomInProportion) {
  const double few = answerTo("fit", 5000, "3").second;
  const auto [fit, many] = answerTo("fit", 20000, "3");
  EXPECT_EQ(fit["arcs"][1]["readings"], 60000);
  EXPECT_LT(many, 8 * few);
}

TEST(Load, PlanOfManyRowsTakesTimeAndRoomInProportion) {
  const double few = answerTo("plan", 5000, "1").second;
  const auto [plan, many] = answerTo("plan", 20000, "1");
  EXPECT_EQ(plan["readings"], 80000);
  EXPECT_LT(many, 8 * few);
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
