#pragma once

#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli protocol` was asked.
struct ProtocolRequest {
  std::string file;                       ///< a path, or - for standard input
  std::string protocol;                   ///< a name, or a file; empty: that of the session
  std::string saveSession, saveTemplate;  ///< paths; empty: not asked for
  bool json = false;
};

/// Adds `protocol FILE [--template NAME|FILE] [--json]`, which fills in `request`.
void addProtocolCommand(CLI::App& app, ProtocolRequest& request);

/// What is next, left, to be repeated, and when it is enough. Fails where session or protocol cannot be used.
Result<std::string> runProtocol(const ProtocolRequest& request);

}  // namespace alidade::console
