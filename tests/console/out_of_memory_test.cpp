#include <gtest/gtest.h>

#include <string>

#include "tests/console/console.h"
#include "tests/support/guarded_memory.h"

// An unexpected failure also ends in one line: the file, that the command failed and why; exit code 1.

namespace alidade::test {
namespace {

TEST(OutOfMemory, IsSaidOfTheFileThatTookIt) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  GTEST_SKIP() << "a sanitizer takes all addresses for itself";
#endif
  const TemporaryFolder folder;
  const std::string notes(24u << 20, 'n');
  const std::string file = folder.file(
      "long.alidade", changedPaperSession([&](nlohmann::ordered_json& json) { json["notes"] = notes; }));
  const ProgramRun run =
      runProgram({.program = "/bin/sh",
                  .arguments = {"-c", "ulimit -v 60000; exec \"$0\" fit \"$1\"", ALIDADE_CLI, file}});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, file + ": the command failed: out of memory\n");
}

}  // namespace
}  // namespace alidade::test
