#pragma once

#include <string>
#include <vector>

#include "app/console/batch.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli history`.
struct HistoryRequest {
  std::vector<std::string> files;  ///< sessions, records, folders or series of them, tables of values
  std::size_t baseline = 0;        ///< number of first entries that set the control limits; 0: all
  BatchOptions batch = {};
};

/// Adds `history FOLDER|VALUES.csv… [--baseline N] [--threads N] [--progress] [--json]`, which fills in
/// `request`.
void addHistoryCommand(CLI::App& app, HistoryRequest& request);

/// Writes the history of each folder, series and table. Sessions or records that are named one by one form
/// one history. Several inputs get a result each (`answerEach`). Unusable files, and sessions without a date,
/// are named on stderr; the others are evaluated. Any unusable file makes the exit code `BadInput`.
int giveHistory(const HistoryRequest& request);

}  // namespace alidade::console
