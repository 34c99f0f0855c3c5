#pragma once

#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli discover`.
struct DiscoverRequest {
  std::string file;  ///< a path, or - for standard input
  bool json = false;
};

/// Adds `discover TABLE.csv [--json]`, which fills in `request`.
void addDiscoverCommand(CLI::App& app, DiscoverRequest& request);

/// The forms in a table of residuals, as text or JSON.
Result<std::string> runDiscover(const DiscoverRequest& request);

}  // namespace alidade::console
