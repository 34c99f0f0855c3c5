#include "app/console/commands/batch_options.h"

#include <CLI/CLI.hpp>

#include "app/console/commands/option_checks.h"

namespace alidade::console {

void addBatchOptions(CLI::App& command, BatchOptions& options) {
  constexpr unsigned mostThreads = 1024;
  command
      .add_option("--threads", options.threads,
                  "Threads for many files; 0: all. The result does not depend on it")
      ->check(wholeFrom(0, mostThreads))
      ->capture_default_str();
  command.add_flag("--progress", options.progress,
                   "Report on stderr how many files are done, even if stderr is no terminal");
  command.add_flag("--json", options.json, "Print one JSON document; of many files, one line for each");
}

}  // namespace alidade::console
