#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/console/batch.h"
#include "app/console/verdict_exit.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli fit`.
struct FitRequest {
  std::vector<std::string> files;   ///< files and folders; `-`: standard input
  std::string method = "rigorous";  ///< or "published"
  double risk = 0.01;               ///< probability of naming a suspect in a sound session
  /// Draws for the Monte Carlo check: a number, or `auto` for as many as needed; empty: none.
  std::string monteCarlo;
  std::uint64_t seed = 1;            ///< seed of the draws
  std::string instrument;            ///< path of an instrument record; empty: none
  std::vector<std::string> effects;  ///< files and folders of effects of the user's own
  std::string csv;                   ///< "residuals", "budget" or "results": table to print; empty: none
  bool diagnosis = true;             ///< whether to diagnose the gap; the verdict then uses the diagnosis
  bool verdictExit = false;          ///< whether the exit code states the verdict
  BatchOptions batch = {};
};

/// Adds `fit FILE… [--method rigorous|published] [--risk P] [--monte-carlo N|auto [--seed S]]
/// [--no-diagnosis] [--instrument RECORD] [--effects FILE|FOLDER]… [--csv residuals|budget|results]
/// [--verdict-exit] [--threads N] [--progress] [--json]`, which fills in `request`.
void addFitCommand(CLI::App& app, FitRequest& request);

/// The fit of one file as text, JSON or table. Fails if the session cannot be read, an arc cannot be fitted
/// or an entry is unusable. The problem names the first unusable entry and the number of the others. A
/// missing position is only a finding. With `verdictExit`, adds the verdict to `verdicts`.
Result<std::string> runFit(const FitRequest& request, const std::string& file, VerdictExit& verdicts);

}  // namespace alidade::console
