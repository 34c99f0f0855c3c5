#pragma once

#include <string>
#include <vector>

#include "app/console/batch.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli history` was asked.
struct HistoryRequest {
  std::vector<std::string> files;  ///< folders of sessions, tables of values, sessions
  BatchOptions batch = {};
};

/// Adds `history FOLDER|VALUES.csv… [--threads N] [--progress] [--json]`, which fills in `request`.
void addHistoryCommand(CLI::App& app, HistoryRequest& request);

/// Writes the history of each folder and table; sessions that are named are of one history. One input gets
/// one answer, several an answer each (`answerEach`). Sessions of a folder that cannot be used or have no
/// date are named on stderr, and the others answered; the exit code then is `BadInput`.
int giveHistory(const HistoryRequest& request);

}  // namespace alidade::console
