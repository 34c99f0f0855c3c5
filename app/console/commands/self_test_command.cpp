#include "app/console/commands/self_test_command.h"

#include <CLI/CLI.hpp>

#include "app/console/channels.h"
#include "app/console/self_test_text.h"
#include "core/base/clock.h"
#include "core/base/file_bytes.h"
#include "core/base/version.h"
#include "core/self_test/self_test.h"

namespace alidade::console {

namespace {

/// Reads the file into `into` if a path is given. Returns false if the file cannot be read.
bool take(const std::string& path, std::string& into) {
  if (path.empty()) return true;
  Result<std::string> text = readFile(path);
  if (!text) {
    refuse(path, text.problem().text());
    return false;
  }
  into = *std::move(text);
  return true;
}

}  // namespace

void addSelfTestCommand(CLI::App& app, SelfTestRequest& request) {
  CLI::App* test = app.add_subcommand(
      "self-test",
      "Check this installation: what was expected, what is found, and the verdict, to be filed.");
  test->add_option("--fits", request.fits,
                   "Compare the fits with these results of tests/reference/high-precision/solve.py, worked "
                   "out by yourself");
  test->add_option("--numbers", request.numbers,
                   "Likewise with the numbers of tests/reference/self-test/make_numbers.py");
  test->add_flag("--json", request.json, "Print one JSON document");
  test->footer("Exit codes: 0 everything passed, 1 anything failed, 2 bad call.");
}

int giveSelfTest(const SelfTestRequest& request) {
  SelfTestReferences references = compiledReferences();
  if (!take(request.fits, references.fits) || !take(request.numbers, references.numbers)) return BadInput;
  SelfTest test = runSelfTest(installedShare(), references);
  test.environment.insert(test.environment.begin(), {"CLI11", CLI11_VERSION});
  const std::string program = "alidade-cli " + versionAndBuild(), at = timeInUtc();
  const int written = writeResult(request.json ? selfTestJson(test, at) : selfTestText(test, program, at));
  if (written != Done) return written;
  return test.hasPassed() ? Done : Failed;
}

}  // namespace alidade::console
