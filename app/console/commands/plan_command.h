#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli plan`.
struct PlanRequest {
  std::string file;                  ///< a path, or - for standard input
  std::vector<std::string> effects;  ///< files and folders of effects of the user's own
  bool json = false;
};

/// Adds `plan FILE [--effects FILE|FOLDER]… [--json]`, which fills in `request`.
void addPlanCommand(CLI::App& app, PlanRequest& request);

/// The review as text or JSON. Fails if the session is unusable.
Result<std::string> runPlan(const PlanRequest& request);

}  // namespace alidade::console
