#pragma once

#include "app/console/batch.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// Adds `[--threads N] [--progress] [--json]` to a subcommand for many files.
void addBatchOptions(CLI::App& command, BatchOptions& options);

}  // namespace alidade::console
