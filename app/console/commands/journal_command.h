#pragma once

#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli journal` was asked.
struct JournalRequest {
  std::string file;  ///< a path, or - for standard input
  bool json = false;
};

/// Adds `journal FILE [--json]`, which fills in `request`.
void addJournalCommand(CLI::App& app, JournalRequest& request);

struct JournalAnswer {
  std::string result;  ///< in text or JSON
  bool holds = true;   ///< nothing was changed outside, as far as the file itself can tell
};

/// Fails where the file is no session; entries of it may be unusable.
Result<JournalAnswer> runJournal(const JournalRequest& request);

}  // namespace alidade::console
