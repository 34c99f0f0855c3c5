#pragma once

#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli journal`.
struct JournalRequest {
  std::string file;  ///< a path, or - for standard input
  bool json = false;
};

/// Adds `journal FILE [--json]`, which fills in `request`.
void addJournalCommand(CLI::App& app, JournalRequest& request);

struct JournalAnswer {
  std::string result;  ///< as text or JSON
  bool holds = true;   ///< true if the file shows no change made outside the program
};

/// Fails if the file is not a session; unusable entries are allowed.
Result<JournalAnswer> runJournal(const JournalRequest& request);

}  // namespace alidade::console
