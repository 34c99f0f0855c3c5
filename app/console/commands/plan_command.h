#pragma once

#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli plan` was asked.
struct PlanRequest {
  std::string file;  ///< a path, or - for standard input
  bool json = false;
};

/// Adds `plan FILE [--json]`, which fills in `request`.
void addPlanCommand(CLI::App& app, PlanRequest& request);

/// The review in text or JSON. Fails where the session cannot be used.
Result<std::string> runPlan(const PlanRequest& request);

}  // namespace alidade::console
