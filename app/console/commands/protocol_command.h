#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli protocol`.
struct ProtocolRequest {
  std::string file;                       ///< a path, or - for standard input
  std::string protocol;                   ///< a name, or a file; empty: the session's protocol
  std::string order;                      ///< "listed" or "by-worth"; empty: as the protocol says
  std::optional<double> uncertainty;      ///< U of Δd, mm, to be reached in an order by worth
  std::string saveSession, saveTemplate;  ///< paths; empty: not requested
  bool json = false;
};

/// Adds `protocol FILE [--template NAME|FILE] [--order ORDER] [--uncertainty MM] [--json]`, which fills in
/// `request`.
void addProtocolCommand(CLI::App& app, ProtocolRequest& request);

/// The next and remaining sightings, those to repeat, and when the readings are enough. Fails if session or
/// protocol is unusable.
Result<std::string> runProtocol(const ProtocolRequest& request);

}  // namespace alidade::console
