#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/console/batch.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli fit` was asked.
struct FitRequest {
  std::vector<std::string> files;   ///< and folders of them; `-`: standard input
  std::string method = "rigorous";  ///< or "published"
  double risk = 0.01;               ///< of naming a suspect in a sound session
  /// Draws to check the uncertainty with: a number, or `auto`, as many as it takes; empty: none.
  std::string monteCarlo;
  std::uint64_t seed = 1;  ///< of the draws
  std::string instrument;  ///< path of an instrument record; empty: none
  std::string csv;         ///< "residuals", "budget" or "results": a table instead; empty: none
  bool diagnosis = true;   ///< of the gap between model and readings, which the verdict heeds
  BatchOptions batch = {};
};

/// Adds `fit FILE… [--method rigorous|published] [--risk P] [--monte-carlo N|auto [--seed S]]
/// [--no-diagnosis] [--instrument RECORD] [--csv residuals|budget|results] [--threads N] [--progress]
/// [--json]`, which fills in `request`.
void addFitCommand(CLI::App& app, FitRequest& request);

/// The fit of one file as text or JSON. Fails where the session cannot be read, where any entry of it is
/// unusable (the first by its place, the others counted), or where an arc cannot be fitted. A missing
/// position is no failure but a finding.
Result<std::string> runFit(const FitRequest& request, const std::string& file);

}  // namespace alidade::console
